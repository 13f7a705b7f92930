# Writes OUTPUT, a source file that defines carom::source_fingerprint: a hash of the files below ROOT that LIST names.
file(STRINGS ${LIST} files)
foreach(file IN LISTS files)
    file(SHA256 ${ROOT}/${file} hash)
    string(APPEND hashes "${file} ${hash}\n")
endforeach()
string(SHA256 all "${hashes}")
string(SUBSTRING ${all} 0 32 all)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[#include "works/source_fingerprint.h"

namespace carom {
const char* const source_fingerprint = "@all@";
}  // namespace carom
]] @ONLY)
