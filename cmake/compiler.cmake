# One set of compiler rules for every module. No fast-math, and no contraction left to the compiler:
# a scene's events and pixels are the same at every optimisation level (std::fma is asked for by name).
add_library(carom_rules INTERFACE)
target_compile_options(carom_rules INTERFACE
    -ffp-contract=off
    -fno-math-errno)  # std::sqrt need not set errno, which nobody reads; the values stay the same
if(CAROM_WARNINGS)
    target_compile_options(carom_rules INTERFACE
        -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms of GCC 12 on std::string, its bug 105651
        # False alarms of GCC 13 and 14: on what variants and optionals hold, and on references that are had
        # from a cache, not from the temporary text that they are asked for with.
        "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized;-Wno-dangling-reference>")
else()
    target_compile_options(carom_rules INTERFACE -w)  # the compiler needs a tenth less time
endif()
if(CAROM_FUZZ)
    # The presets ask for conversions of numbers that are too large, too, which UBSan knows in Clang only. Of coverage there
    # are the counters alone: calls at every comparison take most of the time, and the dictionary has the words that they
    # would find.
    set(carom_sanitizers ${CAROM_FUZZ})
    string(REPLACE "," ";" carom_sanitizer_list "${CAROM_FUZZ}")
    target_compile_options(carom_rules INTERFACE
        -fsanitize-coverage=inline-8bit-counters,pc-table
        -fsanitize-coverage-ignorelist=${CMAKE_CURRENT_LIST_DIR}/uncounted.txt)
    if(NOT "address" IN_LIST carom_sanitizer_list)
        # Checks that only stop the program let the compiler inline small functions. What is found without the address
        # sanitizer is explained by a build with it, which also sees pointers that are null when they are used.
        target_compile_options(carom_rules INTERFACE -fsanitize-trap=all -fno-sanitize=null,alignment)
    endif()
elseif(CAROM_SANITIZE)
    set(carom_sanitizers ${CAROM_SANITIZE})
endif()
if(carom_sanitizers)
    # Indices of containers, and what algorithms ask of their arguments.
    target_compile_definitions(carom_rules INTERFACE CAROM_SANITIZERS _GLIBCXX_ASSERTIONS)
    target_compile_options(carom_rules INTERFACE
        -fsanitize=${carom_sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer
        # False alarms of GCC 12 on variants; and its warning that the thread sanitizer does not know fences.
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-tsan>")
    if(CAROM_SANITIZE MATCHES undefined)
        # Half of the time to compile. The address sanitizer sees null pointers that are used; fuzzing looks for all of it.
        target_compile_options(carom_rules INTERFACE
            -fno-sanitize=null,alignment -fno-sanitize-address-use-after-scope)
    endif()
    target_link_options(carom_rules INTERFACE -fsanitize=${carom_sanitizers})
endif()

find_program(CCACHE ccache)
if(CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
elseif(NOT DEFINED CAROM_UNITY)
    # Several files as one, in a third of the time; with ccache each by itself, so that little is compiled again after a change.
    set(CAROM_UNITY ON)
endif()
if(CAROM_UNITY)
    # False alarms where the unnamed namespaces of several files are one, and of GCC 12 on variants.
    target_compile_options(carom_rules INTERFACE
        -Wno-shadow "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-maybe-uninitialized>"
        # GCC collects garbage less often: 7 % less time for units of this size, and a quarter more memory, up to 1.6 GB.
        $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=200> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
endif()

# Where no inner loop of simulation or drawing is: half of the time to compile in a release, a third less with sanitizers.
set(carom_quick_options $<$<CONFIG:Release>:-Og>)
if(CAROM_SANITIZE)
    set(carom_quick_options -O0)
endif()
