#include "app/figures/figure_folder.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "runs/json.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/files/links.h"
#include "util/files/utf8_names.h"
#include "util/fingerprint.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_manifest_bytes = 16 << 20;

std::string_view as_text(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Json json_of(const WrittenWords& written) {
    const FigureWords& words = written.words;
    Json json{{"inputs", written.inputs},
              {"caption", words.caption},
              {"alt", words.alt},
              {"time", words.time},
              {"times", words.shown.times}};
    if (words.shown.over) json["over"] = *words.shown.over;
    return json;
}

WrittenWords words_in(const Json& json) {
    WrittenWords written{json.at("inputs").get<std::string>(),
                         {.caption = json.at("caption").get<std::string>(),
                          .alt = json.at("alt").get<std::string>(),
                          .time = json.at("time").get<std::string>(),
                          .shown = {json.at("times").get<std::vector<double>>()}}};
    if (json.contains("over"))
        written.words.shown.over = json.at("over").get<std::array<double, 2>>();
    return written;
}

std::string manifest_json(const Manifest& manifest) {
    Json files = Json::object(), figures = Json::object();
    for (const auto& [name, file] : manifest.files) {
        Json& its = files[utf8_of_name(name)];
        its = {{"figure", file.figure}, {"inputs", file.inputs}, {"content", file.content}};
        if (!file.coming.empty()) its["coming"] = file.coming;
    }
    for (const auto& [name, written] : manifest.figures) figures[name] = json_of(written);
    return text_of({{"about", "what carom wrote into this folder, and from what; keep it here"},
                    {"of", utf8_of_name(manifest.of)},
                    {"figures", std::move(figures)},
                    {"files", std::move(files)}},
                   2) +
           "\n";
}

// Parses a manifest; returns nothing if the text is not one.
std::optional<Manifest> read_manifest(std::string_view text) {
    try {
        const Json json = json_in(text);
        Manifest manifest{name_of_utf8(json.at("of").get<std::string>()), {}, {}};
        for (const auto& [name, file] : json.at("files").items())
            manifest.files[name_of_utf8(name)] = {
                file.at("figure").get<std::string>(), file.at("inputs").get<std::string>(),
                file.at("content").get<std::string>(), file.value("coming", "")};
        for (const auto& [name, words] : json.at("figures").items())
            if (words.contains("times")) manifest.figures[name] = words_in(words);
        return manifest;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

FigureFolder::FigureFolder(fs::path path, std::string of, std::string manifest)
    : path_(std::move(path)), manifest_name_(std::move(manifest)) {
    manifest_.of = of;
    const fs::path file = path_ / manifest_name_;
    if (!is_taken(file)) return;
    saved_ = read_file(stored(manifest_name_), most_manifest_bytes);
    auto known = read_manifest(saved_);
    if (!known)
        throw UsageError(
            fmt::format("{}: this file is not the list that carom keeps of what it wrote "
                        "into a folder; choose another folder, or move the file away",
                        file.string()));
    if (known->of != of)
        throw UsageError(
            fmt::format("{}: this folder holds what was made of {}; choose another one "
                        "for {}",
                        path_.string(), known->of, of));
    manifest_ = std::move(*known);
}

bool FigureFolder::is_current(const std::string& file, const std::string& inputs) const {
    const auto known = manifest_.files.find(file);
    return known != manifest_.files.end() && known->second.inputs == inputs &&
           fingerprint_of_file(stored(file)) == known->second.content;
}

std::vector<std::string> FigureFolder::foreign(std::span<const std::string> files) const {
    std::vector<std::string> found;
    for (const std::string& file : files) {
        if (!is_taken(path_ / file)) continue;
        const auto known = manifest_.files.find(file);
        const auto content = fingerprint_of_file(stored(file));
        if (known == manifest_.files.end() || !content ||
            (content != known->second.content && content != known->second.coming))
            found.push_back(file);
    }
    return found;
}

// Records the coming contents of a file. For an existing file of carom, both the old and the new
// fingerprint are recorded until it is replaced.
void FigureFolder::announce(const std::string& file, const std::string& figure,
                            const std::string& content) {
    manifest_.files.try_emplace(file, WrittenFile{figure, "", ""}).first->second.coming = content;
}

void FigureFolder::write(std::span<const NewFile> files) {
    std::vector<std::string> contents;
    bool any = false;
    for (const NewFile& one : files) {
        contents.push_back(fingerprint(as_text(one.bytes)));
        if (fingerprint_of_file(stored(one.file)) == contents.back()) continue;
        announce(one.file, one.figure, contents.back());
        any = true;
    }
    if (any) save();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const NewFile& one = files[i];
        if (fingerprint_of_file(stored(one.file)) != contents[i])
            write_file(stored(one.file), one.bytes);
        manifest_.files[one.file] = {one.figure, one.inputs, contents[i]};
    }
}

void FigureFolder::write(const FilmWriter& film, const std::string& file,
                         const std::string& inputs) {
    GrowingFingerprint all;
    film.copy([&](std::string_view piece) { all.add(piece); });
    announce(file, "", all.digits());
    save();
    AtomicFile output(stored(file));
    film.copy([&](std::string_view piece) { output.write(piece); });
    output.commit();
    manifest_.files[file] = {"", inputs, all.digits()};
}

void FigureFolder::write(AtomicFolder& files, const std::map<std::string, std::string>& contents) {
    const auto record = [&] {
        for (const auto& [file, content] : contents) manifest_.files[file] = {"", "", content};
    };
    if (files.is_new()) {
        record();
        std::string text = manifest_json(manifest_);
        files.write_pieces(manifest_name_, [&](const TakePiece& take) { take(text); });
        files.commit();
        saved_ = std::move(text);
        return;
    }
    for (const auto& [file, content] : contents) announce(file, "", content);
    save();
    files.commit();
    record();
}

void FigureFolder::remember(const std::string& figure, WrittenWords words) {
    manifest_.figures[figure] = std::move(words);
}

std::vector<std::string> FigureFolder::remove_all_but(const std::set<std::string>& kept,
                                                      std::vector<std::string>& removed) {
    std::vector<std::string> left;
    std::erase_if(manifest_.files, [&](const auto& known) {
        const auto& [file, written] = known;
        if (kept.contains(file)) return false;
        if (!is_taken(path_ / file)) return true;
        // The manifest may come from elsewhere: a name that leads out of the folder is not one of
        // carom's files there.
        const bool is_own = fingerprint_of_file(stored(file)) == written.content;
        (is_own && remove_stored(stored(file)) ? removed : left).push_back(file);
        return true;
    });
    return left;
}

void FigureFolder::save() {
    if (saved_.empty() && manifest_.files.empty() && manifest_.figures.empty()) return;
    std::string text = manifest_json(manifest_);
    if (text == saved_) return;
    write_file(stored(manifest_name_), text);
    saved_ = std::move(text);
}

}  // namespace carom
