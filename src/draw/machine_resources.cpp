#include "draw/machine_resources.h"

#include <fmt/format.h>

#include "draw/fonts/font_threads.h"
#include "draw/text.h"
#include "util/text.h"
#include "util/threads/on_threads.h"

namespace carom {
namespace {

// Address space: stack and heap of a drawing thread and of the thread that finds its fonts.
constexpr std::size_t bytes_of_thread = 148'000'000;

void set_text() {
    for (const int weight : {400, 500, 600}) measure_text("0", {.weight = weight});
}

}  // namespace

void require_machine_resources(int threads, std::size_t bytes) {
    require_font();
    require_memory(bytes + static_cast<std::size_t>(threads) * bytes_of_thread,
                   fmt::format("work on {}", counted(threads, "thread")), threads);
    require_threads(threads * (1 + threads_of_pango) + threads_of_pango, [] {});  // and this one's
    require_threads(threads, set_text);
}

}  // namespace carom
