// A library to be preloaded: the open number FAIL_OPEN_NUMBER (from 1) of a file whose path
// contains FAIL_OPEN_OF fails with EMFILE.
#include <dlfcn.h>
#include <fcntl.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

bool fails(const char* path) {
    static const char* const of = std::getenv("FAIL_OPEN_OF");
    static const char* const number = std::getenv("FAIL_OPEN_NUMBER");
    static std::atomic<long> opened = 0;
    if (of == nullptr || number == nullptr || std::strstr(path, of) == nullptr) return false;
    if (++opened != std::atol(number)) return false;
    errno = EMFILE;
    return true;
}

using Open = int (*)(const char*, int, ...);

int opened(const char* name, const char* path, int flags, mode_t mode) {
    if (fails(path)) return -1;
    return reinterpret_cast<Open>(dlsym(RTLD_NEXT, name))(path, flags, mode);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opened("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opened("open64", path, flags, mode);
}
}
