#include <glib.h>

#include <memory>

#include "draw/text.h"

namespace carom {

std::string escape_markup(const std::string& text) {
    const std::unique_ptr<char, decltype(&g_free)> escaped(
        g_markup_escape_text(text.data(), static_cast<gssize>(text.size())), &g_free);
    return escaped.get();
}

}  // namespace carom
