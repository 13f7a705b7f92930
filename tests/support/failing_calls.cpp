// A library for LD_PRELOAD that makes one system call fail, or write only half of its bytes.
// FAULT_CALL names a class of calls (below), FAULT_NUMBER is the number of the failing call,
// counted from 1, and FAULT_ERROR its errno, or "short" for a partial write. If FAULT_OF is set,
// only calls with a path that contains it are counted. At exit one line for each class, with its
// number of calls, is written to the file FAULT_COUNTS.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Class {
    opening,
    reading,
    writing,
    naming,
    syncing,
    closing,
    folder,
    sizing,
    seeking,
    status,
    mapping,
    memory,
    thread,
    classes
};
constexpr std::array<const char*, classes> names{"open",  "read",   "write",    "name", "sync",
                                                 "close", "mkdir",  "truncate", "seek", "status",
                                                 "map",   "memory", "thread"};

constinit std::array<std::atomic<long>, classes> calls{};

struct Fault {
    int of = -1;
    long number = 0;
    int error = 0;  // 0: a short write
    const char* path = nullptr;
};

// Must not allocate, as it is also called from malloc.
Fault chosen() {
    Fault fault;
    const char* const of = std::getenv("FAULT_CALL");
    const char* const number = std::getenv("FAULT_NUMBER");
    const char* const error = std::getenv("FAULT_ERROR");
    if (of == nullptr || number == nullptr || error == nullptr) return fault;
    for (int i = 0; i < classes; ++i)
        if (std::strcmp(names[i], of) == 0) fault.of = i;
    fault.number = std::atol(number);
    fault.error = std::atoi(error);
    fault.path = std::getenv("FAULT_OF");
    return fault;
}

// Nothing fails before the constructors of this library have run: until then the dynamic loader is
// at work.
constinit Fault fault{};
constinit bool is_ready = false;

__attribute__((constructor)) void begin() {
    fault = chosen();
    is_ready = true;
}

bool is_chosen(Class of, const char* path = nullptr) {
    if (!is_ready) return false;
    if (fault.path != nullptr && (path == nullptr || std::strstr(path, fault.path) == nullptr))
        return false;
    return ++calls[of] == fault.number && fault.of == of;
}

bool fails(Class of, const char* path = nullptr) {
    if (!is_chosen(of, path) || fault.error == 0) return false;
    errno = fault.error;
    return true;
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

using Open = int(const char*, int, ...);
using OpenAt = int(int, const char*, int, ...);

bool creates(int flags) {
#ifdef O_TMPFILE
    if ((flags & O_TMPFILE) == O_TMPFILE) return true;
#endif
    return (flags & O_CREAT) != 0;
}

mode_t mode_in(int flags, va_list rest) { return creates(flags) ? va_arg(rest, mode_t) : 0; }

}  // namespace

// Returns `failure` if this call is the one to fail; otherwise calls the real function.
#define CALL(of, path, failure, name, ...)                   \
    if (fails(of, path)) return failure;                     \
    static auto* const call = next<decltype(::name)>(#name); \
    return call(__VA_ARGS__)

#define OPENING(name)                                     \
    int name(const char* path, int flags, ...) {          \
        va_list rest;                                     \
        va_start(rest, flags);                            \
        const mode_t mode = mode_in(flags, rest);         \
        va_end(rest);                                     \
        CALL(opening, path, -1, name, path, flags, mode); \
    }

#define OPENING_AT(name)                                      \
    int name(int at, const char* path, int flags, ...) {      \
        va_list rest;                                         \
        va_start(rest, flags);                                \
        const mode_t mode = mode_in(flags, rest);             \
        va_end(rest);                                         \
        CALL(opening, path, -1, name, at, path, flags, mode); \
    }

extern "C" {

OPENING(open)
OPENING(open64)

// A sanitizer intercepts these calls itself.
#if defined(__GLIBC__) && !defined(CAROM_SANITIZERS)

OPENING_AT(openat)
OPENING_AT(openat64)
int creat(const char* path, mode_t mode) { CALL(opening, path, -1, creat, path, mode); }
FILE* fopen(const char* path, const char* mode) { CALL(opening, path, nullptr, fopen, path, mode); }
FILE* fopen64(const char* path, const char* mode) {
    CALL(opening, path, nullptr, fopen64, path, mode);
}
DIR* opendir(const char* path) { CALL(opening, path, nullptr, opendir, path); }
int mkostemp(char* path, int flags) { CALL(opening, path, -1, mkostemp, path, flags); }

ssize_t read(int file, void* data, size_t size) {
    CALL(reading, nullptr, -1, read, file, data, size);
}

ssize_t write(int file, const void* data, size_t size) {
    if (is_chosen(writing)) {
        if (fault.error != 0) {
            errno = fault.error;
            return -1;
        }
        size = (size + 1) / 2;
    }
    return syscall(SYS_write, file, data, size);
}
ssize_t writev(int file, const iovec* parts, int count) {
    if (is_chosen(writing)) {
        if (fault.error == 0 && count > 0)
            return syscall(SYS_write, file, parts->iov_base, (parts->iov_len + 1) / 2);
        errno = fault.error;
        return -1;
    }
    return syscall(SYS_writev, file, parts, count);
}
ssize_t pwrite64(int file, const void* data, size_t size, off64_t at) {
    if (is_chosen(writing)) {
        if (fault.error != 0) {
            errno = fault.error;
            return -1;
        }
        size = (size + 1) / 2;
    }
    return syscall(SYS_pwrite64, file, data, size, at);
}
ssize_t pwrite(int file, const void* data, size_t size, off_t at) {
    return pwrite64(file, data, size, at);
}
ssize_t pread(int file, void* data, size_t size, off_t at) {
    CALL(reading, nullptr, -1, pread, file, data, size, at);
}
ssize_t pread64(int file, void* data, size_t size, off64_t at) {
    CALL(reading, nullptr, -1, pread64, file, data, size, at);
}

off_t lseek(int file, off_t at, int from) noexcept {
    CALL(seeking, nullptr, -1, lseek, file, at, from);
}
off64_t lseek64(int file, off64_t at, int from) noexcept {
    CALL(seeking, nullptr, -1, lseek64, file, at, from);
}
int fstat(int file, struct stat* found) noexcept { CALL(status, nullptr, -1, fstat, file, found); }
int fstat64(int file, struct stat64* found) noexcept {
    CALL(status, nullptr, -1, fstat64, file, found);
}

int rename(const char* from, const char* to) noexcept { CALL(naming, to, -1, rename, from, to); }
int linkat(int at, const char* from, int to_at, const char* to, int flags) noexcept {
    CALL(naming, to, -1, linkat, at, from, to_at, to, flags);
}
int unlink(const char* path) noexcept { CALL(naming, path, -1, unlink, path); }

int fsync(int file) { CALL(syncing, nullptr, -1, fsync, file); }
int fdatasync(int file) { CALL(syncing, nullptr, -1, fdatasync, file); }

// As on Linux, the file is closed even if close reports an error.
int close(int file) {
    const bool chosen = fails(closing);
    const long closed = syscall(SYS_close, file);
    if (!chosen) return static_cast<int>(closed);
    errno = fault.error;
    return -1;
}

int mkdir(const char* path, mode_t mode) noexcept { CALL(folder, path, -1, mkdir, path, mode); }
char* mkdtemp(char* path) noexcept { CALL(folder, path, nullptr, mkdtemp, path); }

int ftruncate(int file, off_t size) noexcept { CALL(sizing, nullptr, -1, ftruncate, file, size); }
int ftruncate64(int file, off64_t size) noexcept {
    CALL(sizing, nullptr, -1, ftruncate64, file, size);
}
int posix_fallocate(int file, off_t at, off_t size) {
    if (is_chosen(sizing)) return fault.error;
    return next<decltype(::posix_fallocate)>("posix_fallocate")(file, at, size);
}

void* mmap(void* at, size_t size, int rights, int flags, int file, off_t from) noexcept {
    if (fails(mapping)) return MAP_FAILED;
    return reinterpret_cast<void*>(syscall(SYS_mmap, at, size, rights, flags, file, from));
}
void* mmap64(void* at, size_t size, int rights, int flags, int file, off64_t from) noexcept {
    return mmap(at, size, rights, flags, file, from);
}

int pthread_create(pthread_t* id, const pthread_attr_t* how, void* (*work)(void*),
                   void* with) noexcept {
    if (is_chosen(thread)) return fault.error;
    return next<decltype(::pthread_create)>("pthread_create")(id, how, work, with);
}

// dlsym allocates, so the allocation functions call the internal ones of glibc.
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) { return fails(memory) ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) {
    return fails(memory) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
    return fails(memory) ? nullptr : __libc_realloc(old, size);
}
void* memalign(size_t alignment, size_t size) {
    return fails(memory) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {  // not by the program's own memalign
    return fails(memory) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** made, size_t alignment, size_t size) {
    if (is_chosen(memory)) return fault.error;
    void* const found = __libc_memalign(alignment, size);
    if (found == nullptr) return ENOMEM;
    *made = found;
    return 0;
}

__attribute__((destructor)) void report() {
    const char* const path = std::getenv("FAULT_COUNTS");
    if (path == nullptr) return;
    std::array<char, 512> text{};
    int length = 0;
    for (int i = 0; i < classes; ++i)
        length += std::snprintf(text.data() + length, text.size() - length, "%s %ld\n", names[i],
                                calls[i].load());
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    syscall(SYS_write, file, text.data(), length);
    syscall(SYS_close, file);
}
#endif
}
