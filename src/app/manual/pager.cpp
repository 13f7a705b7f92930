#include "app/manual/pager.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "app/output.h"

namespace carom {

void show_pages(const std::string& text) {
    const char* pager = std::getenv("PAGER");
    if (pager != nullptr && *pager != '\0' && isatty(STDOUT_FILENO) == 1) {
        if (std::FILE* pipe = popen(pager, "w")) {
            std::fwrite(text.data(), 1, text.size(), pipe);  // a reader may stop before the end
            constexpr int not_found = 127;
            const int status = pclose(pipe);
            if (!(WIFEXITED(status) && WEXITSTATUS(status) == not_found)) return;
        }
    }
    Output("-").write(text);
}

}  // namespace carom
