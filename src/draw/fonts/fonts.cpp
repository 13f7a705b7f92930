#include "draw/fonts/fonts.h"

#include <cairo.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <pango/pangofc-font.h>
#include <pango/pangofc-fontmap.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "draw/fonts/font_threads.h"
#include "util/diagnostics.h"
#include "util/threads/on_threads.h"

namespace carom {
namespace {

using FontConfig = Owned<FcConfig, FcConfigDestroy>;
using Pattern = Owned<FcPattern, FcPatternDestroy>;
using ObjectSet = Owned<FcObjectSet, FcObjectSetDestroy>;
using FontSet = Owned<FcFontSet, FcFontSetDestroy>;
using FontOptions = Owned<cairo_font_options_t, cairo_font_options_destroy>;
using Description = Owned<PangoFontDescription, pango_font_description_free>;
using Text = Owned<char, g_free>;
using LayoutIter = Owned<PangoLayoutIter, pango_layout_iter_free>;

std::string file_of(FcPattern* pattern) {
    FcChar8* file = nullptr;
    if (FcPatternGetString(pattern, FC_FILE, 0, &file) != FcResultMatch) return "";
    return reinterpret_cast<const char*>(file);
}

// carom draws words in weights from regular to semi-bold, and samples of lines as dashes in black
// weight. A variable font has a range of weights instead of one.
bool has_a_used_weight(FcPattern* pattern) {
    double weight = 0.0;
    return FcPatternGetDouble(pattern, FC_WEIGHT, 0, &weight) != FcResultMatch ||
           (weight >= FC_WEIGHT_REGULAR && weight <= FC_WEIGHT_DEMIBOLD) ||
           weight >= FC_WEIGHT_BLACK;
}

// Whether the fonts provide all weights that carom uses, by fonts of one weight each or by one with
// a range.
bool have_used_weights(std::span<FcPattern* const> fonts) {
    return std::ranges::all_of(
        std::array{FC_WEIGHT_REGULAR, FC_WEIGHT_MEDIUM, FC_WEIGHT_DEMIBOLD, FC_WEIGHT_BLACK},
        [&](int used) {
            return std::ranges::any_of(fonts, [used](FcPattern* font) {
                double weight = 0.0;
                return FcPatternGetDouble(font, FC_WEIGHT, 0, &weight) != FcResultMatch ||
                       weight == used;
            });
        });
}

// The libraries do not report why they could not read the file: the reason is found by opening it
// again.
[[noreturn]] void refuse(const std::string& file) {
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const int error = descriptor >= 0 ? EMFILE : errno;
    const std::string reason = descriptor >= 0
                                   ? "it can be opened now; there was no memory for it, or too "
                                     "many files were open"
                                   : std::generic_category().message(error);
    if (descriptor >= 0) close(descriptor);
    throw_system_error(fmt::format("cannot read the font {}: {}", file, reason), error);
}

// GLib terminates the program if it has no memory or cannot start a thread, and leaves what was
// begun; unnamed files vanish with the process.
[[noreturn]] void end_of_glib(const char* message) {
    write_to_standard_error(
        {"carom: the libraries that set text cannot go on: ", message,
         "\n       a higher limit of memory or of threads (ulimit -v, ulimit -u) helps\n"});
    _exit(1);
}

// A font about which Pango warns is refused where it is used.
GLogWriterOutput on_glib_message(GLogLevelFlags level, const GLogField* fields, gsize count,
                                 gpointer data) {
    std::string_view domain;
    const char* message = "";
    for (const GLogField& field : std::span(fields, count)) {
        const std::string_view key = field.key;
        if (key == "GLIB_DOMAIN") domain = static_cast<const char*>(field.value);
        if (key == "MESSAGE") message = static_cast<const char*>(field.value);
    }
    if ((level & G_LOG_LEVEL_ERROR) != 0) end_of_glib(message);
    if (domain == "Pango" && level == G_LOG_LEVEL_WARNING) return G_LOG_WRITER_HANDLED;
    return g_log_writer_default(level, fields, count, data);
}

// The address space needed for the fonts, their caches, and the thread (with its heap) that
// searches for them: the measured amount and a margin.
constexpr std::size_t first_text_bytes = 192'000'000;

[[noreturn]] void refuse_configuration() {
    throw SystemError("fontconfig cannot read its configuration: there is no memory for it");
}

// The full font configuration of this machine; reading it takes a quarter of the time of `carom
// check`.
FcConfig* machine() {
    static const FontConfig all{FcInitLoadConfigAndFonts()};
    if (!all) refuse_configuration();
    return all.get();
}

// A configuration with the folders that Fontconfig searches by default, with its caches on Debian
// and Fedora; of the fonts there only the declared families. The fonts are known from the caches,
// as scanned by the machine's rules: no font file is read for it.
std::string declared_in_usual_folders(std::span<const std::string> families) {
    std::string accepted;
    for (const std::string& family : families) {
        const Text escaped{g_markup_escape_text(family.data(), static_cast<gssize>(family.size()))};
        accepted +=
            fmt::format("<pattern><patelt name=\"family\"><string>{}</string></patelt></pattern>",
                        escaped.get());
    }
    return fmt::format(
        "<fontconfig><dir>/usr/share/fonts</dir><dir>/usr/local/share/fonts</dir>"
        "<dir prefix=\"xdg\">fonts</dir><dir>~/.fonts</dir>"
        "<cachedir>/var/cache/fontconfig</cachedir><cachedir>/usr/lib/fontconfig/cache</cachedir>"
        "<cachedir prefix=\"xdg\">fontconfig</cachedir>"
        "<selectfont><rejectfont><pattern/></rejectfont><acceptfont>{}"
        "</acceptfont></selectfont></fontconfig>",
        accepted);
}

bool is_configured_by_environment() {
    return std::ranges::any_of(
        std::array{"FONTCONFIG_FILE", "FONTCONFIG_PATH", "FONTCONFIG_SYSROOT"},
        [](const char* name) { return std::getenv(name) != nullptr; });
}

// Whether one of the fonts is of a family, by one of the names that it has.
bool has_family(const FcFontSet* fonts, const std::string& family) {
    const auto* const wanted = reinterpret_cast<const FcChar8*>(family.c_str());
    for (int i = 0; fonts != nullptr && i < fonts->nfont; ++i) {
        FcChar8* name = nullptr;
        for (int k = 0; FcPatternGetString(fonts->fonts[i], FC_FAMILY, k, &name) == FcResultMatch;
             ++k)
            if (FcStrCmpIgnoreCase(name, wanted) == 0) return true;
    }
    return false;
}

// A configuration that knows none but the usual family and, if it is another, the declared one.
class DeclaredFonts {
  public:
    explicit DeclaredFonts(const std::string& family) {
        const bool is_usual = family == font_family;
        std::vector<std::string> families{font_family};
        if (!is_usual) families.push_back(family);
        // Without memory for fontconfig, or a thread for Pango, these would terminate the program.
        require_memory(first_text_bytes, "setting text");
        require_threads(threads_of_pango, [] {});
        if (is_usual) g_log_set_writer_func(on_glib_message, nullptr, nullptr);
        own_.reset(FcConfigCreate());
        const std::string text =
            is_configured_by_environment() ? "<fontconfig/>" : declared_in_usual_folders(families);
        if (!own_ ||
            !FcConfigParseAndLoadFromMemory(
                own_.get(), reinterpret_cast<const FcChar8*>(text.c_str()), FcTrue) ||
            !FcConfigBuildFonts(own_.get()))
            refuse_configuration();
        // Otherwise Pango would read the configuration of the machine.
        if (is_usual && !FcConfigSetCurrent(own_.get())) refuse_configuration();
        const FcFontSet* found = FcConfigGetFonts(own_.get(), FcSetSystem);
        if (!is_usual) {
            has_font_ = has_family(found, family) || add_machine_fonts(family);
            if (!has_family(found, font_family)) add_machine_fonts(font_family);
            return;
        }
        has_font_ = found != nullptr && found->nfont > 0;
        if (!has_font_ || !have_used_weights({found->fonts, std::size_t(found->nfont)}))
            has_font_ |= add_machine_fonts(family);
    }

    bool has_font() const { return has_font_; }
    FcConfig* get() const { return own_.get(); }

  private:
    // A family from wherever the machine is configured to have fonts; whether it has any.
    bool add_machine_fonts(const std::string& family) {
        bool has_any = false;
        const Pattern wanted{FcPatternCreate()};
        const ObjectSet fields{FcObjectSetBuild(FC_FILE, FC_WEIGHT, nullptr)};
        if (!wanted || !fields) refuse_configuration();
        FcPatternAddString(wanted.get(), FC_FAMILY,
                           reinterpret_cast<const FcChar8*>(family.c_str()));
        const FontSet found{FcFontList(machine(), wanted.get(), fields.get())};
        if (!found) refuse_configuration();
        for (int i = 0; i < found->nfont; ++i) {
            if (family == font_family && !has_a_used_weight(found->fonts[i]))
                continue;  // each takes a millisecond to read
            const std::string file = file_of(found->fonts[i]);
            if (!FcConfigAppFontAddFile(own_.get(), reinterpret_cast<const FcChar8*>(file.c_str())))
                refuse(file);
            has_any = true;
        }
        return has_any;
    }

    FontConfig own_;
    bool has_font_ = false;
};

const DeclaredFonts& declared(const std::string& family) {
    static const DeclaredFonts usual{font_family};
    if (family == font_family) return usual;
    static std::mutex mutex;
    static std::map<std::string, DeclaredFonts> others;
    const std::scoped_lock lock(mutex);
    return others.try_emplace(family, family).first->second;
}

Fonts fonts_of(FcConfig* configuration) {
    Fonts fonts;
    fonts.map.reset(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
    pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(fonts.map.get()), configuration);
    fonts.context.reset(pango_font_map_create_context(fonts.map.get()));
    PangoContext* context = fonts.context.get();
    const FontOptions options{cairo_font_options_create()};
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context, options.get());
    pango_context_set_round_glyph_positions(context, FALSE);
    pango_context_set_language(context, pango_language_from_string("en"));
    pango_context_set_base_dir(context, PANGO_DIRECTION_WEAK_LTR);
    return fonts;
}

// Whether a letter is in its font but was not found there: the file could not be read when the line
// was shaped.
bool lacks_its_letter(FcPattern* pattern, PangoGlyph glyph) {
    FcCharSet* letters = nullptr;
    return (glyph & PANGO_GLYPH_UNKNOWN_FLAG) != 0 && glyph != PANGO_GLYPH_INVALID_INPUT &&
           FcPatternGetCharSet(pattern, FC_CHARSET, 0, &letters) == FcResultMatch &&
           FcCharSetHasChar(letters, glyph & ~PANGO_GLYPH_UNKNOWN_FLAG);
}

void require_font_of(const PangoGlyphItem& run, int weight) {
    PangoFont* font = run.item->analysis.font;
    if (font == nullptr || !PANGO_IS_FC_FONT(font)) return;
    FcPattern* pattern = pango_fc_font_get_pattern(PANGO_FC_FONT(font));
    cairo_scaled_font_t* scaled = pango_cairo_font_get_scaled_font(PANGO_CAIRO_FONT(font));
    if (scaled == nullptr || cairo_scaled_font_status(scaled) != CAIRO_STATUS_SUCCESS)
        refuse(file_of(pattern));
    for (int i = 0; i < run.glyphs->num_glyphs; ++i)
        if (lacks_its_letter(pattern, run.glyphs->glyphs[i].glyph)) refuse(file_of(pattern));
    const Description description{pango_font_describe(font)};
    constexpr int step = 100;  // difference between neighbouring weights of a family
    if (weight > 0 &&
        std::abs(pango_font_description_get_weight(description.get()) - weight) >= step)
        throw SystemError(fmt::format(
            "the typeface {} lacks the weight {} on this machine, or its file cannot be read: "
            "install the Debian package fonts-inter again",
            font_family, weight));
}

}  // namespace

Fonts declared_fonts(const std::string& family) {
    const DeclaredFonts& fonts = declared(family);
    if (!fonts.has_font())
        throw SystemError(
            fmt::format("the typeface {} is not installed on this machine{}", family,
                        family == font_family ? ": install the Debian package fonts-inter" : ""));
    return fonts_of(fonts.get());
}

std::vector<std::string> families_of_machine() {
    const Pattern any{FcPatternCreate()};
    const ObjectSet fields{FcObjectSetBuild(FC_FAMILY, nullptr)};
    if (!any || !fields) refuse_configuration();
    const FontSet found{FcFontList(machine(), any.get(), fields.get())};
    if (!found) refuse_configuration();
    std::set<std::string> names;
    for (int i = 0; i < found->nfont; ++i) {
        FcChar8* name = nullptr;
        for (int k = 0; FcPatternGetString(found->fonts[i], FC_FAMILY, k, &name) == FcResultMatch;
             ++k)
            names.insert(reinterpret_cast<const char*>(name));
    }
    return {names.begin(), names.end()};
}

Fonts machine_fonts() { return fonts_of(machine()); }

void require_fonts_of(PangoLayout* layout, int weight) {
    const LayoutIter iter{pango_layout_get_iter(layout)};
    do {
        if (const PangoGlyphItem* run = pango_layout_iter_get_run_readonly(iter.get()))
            require_font_of(*run, weight);
    } while (pango_layout_iter_next_run(iter.get()) != 0);
}

void require_drawn(cairo_t* context) {
    const cairo_status_t status = cairo_status(context);
    if (status != CAIRO_STATUS_SUCCESS)
        throw SystemError(
            fmt::format("cannot draw letters: {}; is a font gone, or is there no "
                        "memory for it?",
                        cairo_status_to_string(status)));
}

}  // namespace carom
