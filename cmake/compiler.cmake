# Compiler rules shared by all modules. Neither -ffast-math nor automatic contraction of
# floating-point operations is allowed: the events and pixels of a scene are the same at every
# optimisation level (std::fma is called explicitly).
add_library(carom_rules INTERFACE)
target_compile_options(carom_rules INTERFACE
    -ffp-contract=off
    -fno-math-errno)  # std::sqrt need not set errno, which nothing reads; results are unchanged
if(CAROM_WARNINGS)
    target_compile_options(carom_rules INTERFACE
        -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false positives on std::string, GCC bug 105651
        # False positives of GCC 13 and 14: on the contents of variants and optionals, and on
        # references that come from a cache rather than from the temporary text that is passed to
        # look them up.
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized;-Wno-dangling-reference>")
else()
    target_compile_options(carom_rules INTERFACE -w)  # saves a tenth of the compile time
endif()
if(CAROM_FUZZ)
    # The presets also ask for a check of numeric conversions that overflow, which only the UBSan of
    # Clang has. Coverage uses counters only: callbacks at every comparison would take most of the
    # time, and the dictionary already has the words that they would find.
    set(carom_sanitizers ${CAROM_FUZZ})
    string(REPLACE "," ";" carom_sanitizer_list "${CAROM_FUZZ}")
    target_compile_options(carom_rules INTERFACE
        -fsanitize-coverage=inline-8bit-counters,pc-table
        -fsanitize-coverage-ignorelist=${CMAKE_CURRENT_LIST_DIR}/uncounted.txt)
    if(NOT "address" IN_LIST carom_sanitizer_list)
        # Checks that only trap let the compiler inline small functions. What is found without the
        # address sanitizer is explained by a build with it, which also detects the use of null
        # pointers.
        target_compile_options(carom_rules INTERFACE -fsanitize-trap=all -fno-sanitize=null,alignment)
    endif()
elseif(CAROM_SANITIZE)
    set(carom_sanitizers ${CAROM_SANITIZE})
endif()
if(carom_sanitizers)
    # Checks of container indices and of the preconditions of standard algorithms.
    target_compile_definitions(carom_rules INTERFACE CAROM_SANITIZERS _GLIBCXX_ASSERTIONS)
    target_compile_options(carom_rules INTERFACE
        -fsanitize=${carom_sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer
        # False positives of GCC 12 on variants, and its warning that the thread sanitizer does not
        # support fences.
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-tsan>")
    if(CAROM_SANITIZE MATCHES undefined)
        # Halves the compile time. The address sanitizer still detects the use of null pointers, and
        # the fuzzing builds check everything.
        target_compile_options(carom_rules INTERFACE
            -fno-sanitize=null,alignment -fno-sanitize-address-use-after-scope)
    endif()
    target_link_options(carom_rules INTERFACE -fsanitize=${carom_sanitizers})
endif()

find_program(CCACHE ccache)
if(CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
elseif(NOT DEFINED CAROM_UNITY)
    # A unity build takes a third of the time. With ccache each file is compiled separately, so that
    # little has to be recompiled after a change.
    set(CAROM_UNITY ON)
endif()
if(CAROM_UNITY)
    # False positives where several files share one unnamed namespace, and of GCC 12 on variants.
    target_compile_options(carom_rules INTERFACE
        -Wno-shadow "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-maybe-uninitialized>"
        # Fewer garbage collections in GCC: 7 % less time for units of this size, for a quarter more
        # memory, up to 1.7 GB.
        $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=200> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
endif()

# Options for code without inner loops of simulation or drawing: half the compile time in a release
# build, a third less with sanitizers.
set(carom_quick_options $<$<CONFIG:Release>:-Og>)
if(CAROM_SANITIZE)
    set(carom_quick_options -O0)
endif()
