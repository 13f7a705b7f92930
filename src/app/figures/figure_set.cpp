#include "app/figures/figure_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "app/figures/figure_pages.h"
#include "draw/machine_resources.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "figures/sweep_figure.h"
#include "films/first_pass.h"
#include "films/render.h"
#include "media/formats.h"
#include "panels/registry.h"
#include "runs/run_progress.h"
#include "scene/panel_kind.h"
#include "util/diagnostics.h"
#include "util/files/input_file.h"
#include "util/fingerprint.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

struct PlannedFigure {
    const SetPart* part;
    const FigureSpec* spec;
    std::string inputs;                 ///< fingerprint of what its files are made from
    bool chosen;                        ///< to be drawn if it is not up to date
    std::vector<std::string> due = {};  ///< its files that are to be made
};

// Joins texts so that the boundaries between them count.
std::string all_of(std::initializer_list<std::string_view> texts) {
    std::string all;
    for (const std::string_view text : texts) all += fmt::format("{}:{};", text.size(), text);
    return all;
}

// Fingerprint of the inputs from which `what` is made of a scene.
std::string inputs_of(const Scene& scene, std::string_view what) {
    std::string overrides;
    for (const std::string& one : scene.source.overrides) overrides += all_of({one});
    std::string all =
        all_of({CAROM_VERSION, scene.source.text, scene.source.template_text, overrides, what});
    if (!scene.source.look_text.empty()) all += all_of({scene.source.look_text});
    return fingerprint(all);
}

// A film is made from the scene beside it, too.
std::string inputs_of_film(const Scene& scene) {
    std::string all = inputs_of(scene, "the film");  // a figure cannot have this name
    for (const auto& [file, text] : scene.source.files) all += all_of({text});
    return fingerprint(all);
}

// A figure that compares runs is made from all their scenes, too.
std::string inputs_of(const Scene& scene, const FigureSpec& figure) {
    std::string all = inputs_of(scene, figure.name);
    if (figure.compare.empty() && !figure.panel.joined) return all;
    for (const ComparedRun& run : figure.compare)
        all += all_of({run.label, inputs_of(*run.scene, figure.name)});
    if (figure.panel.joined) all += fingerprint_of_file(path_of_joined(scene, figure)).value_or("");
    return fingerprint(all);
}

std::vector<std::uint8_t> bytes_of(const FigureRun& run, const Figure& figure,
                                   const FigureWords& words, const std::string& origin,
                                   const std::filesystem::path& file) {
    const EndsAtOnce whole;
    const OutputFormat& its = output_format(file.extension().string().substr(1));
    if (its.stills)
        return draw_figure(run, figure, its.vector, {run.scene().title, words.alt, origin}).file();
    const std::string text = csv(table_of(figure));
    return {text.begin(), text.end()};
}

RunsCallbacks shown_runs(const Scene& scene, Progress& progress) {
    return {
        .trial = shown_trials(scene, progress),
        .begin = [&](double time) { progress.begin("simulating", time, "time units"); },
        .advance = [&](double time) { progress.advance(time); },
    };
}

// The names of a film's file and of the files next to it, by role.
std::map<std::string, std::string> film_files(const SetPart& part) {
    std::map<std::string, std::string> files{{"film", part.stem + ".mp4"},
                                             {"poster", part.stem + ".poster.png"}};
    for (const auto& [what, ending] : text_endings)
        if (what != "captions" || has_captions(part.scene)) files[what] = part.stem + ending;
    return files;
}

void refuse_unknown(const FigureSet& set, const std::vector<std::string>& only) {
    std::vector<std::string> names;
    for (const SetPart& part : set.parts)
        names.insert(names.end(), part.figures.begin(), part.figures.end());
    for (const std::string& name : only) {
        if (std::ranges::find(names, name) != names.end()) continue;
        throw UsageError(fmt::format("--only {}: {} has no figure of this name; {}", name, set.of,
                                     spelling_hint(name, names, "it has " + listed(names))));
    }
}

// The files of a figure. A figure of words has no numbers, and so no table.
std::vector<std::string> figure_files(const FigureSet& set, const FigureSpec& spec) {
    std::vector<std::string> files;
    for (const std::string& format : set.formats)
        if (format != "csv" || kind_of(spec.panel).shows_run)
            files.push_back(spec.name + "." + format);
    return files;
}

class Maker {
  public:
    Maker(const FigureSet& set, const SetOptions& options)
        : set_(set), options_(options), folder_(set.folder, set.of) {
        for (const SetPart& part : set.parts)
            for (const std::string& name : part.figures) plan(part, *figure_spec(part.scene, name));
    }

    SetReport make() {
        refuse_foreign();
        for (const PageTemplate& page : set_.pages)  // report mistakes before the work
            refuse_page(page);
        try {
            for (const SetPart& part : set_.parts) draw(part);
            for (const SetPart& part : set_.parts) render_film(part);
            write_words();
        } catch (...) {
            folder_.save();  // record what was written, however the work ended
            throw;
        }
        folder_.save();
        report_.gone = gone();
        return report_;
    }

  private:
    void plan(const SetPart& part, const FigureSpec& spec) {
        const auto& only = options_.only;
        PlannedFigure figure{&part, &spec, inputs_of(part.scene, spec),
                             only.empty() || std::ranges::find(only, spec.name) != only.end()};
        for (const std::string& file : figure_files(set_, spec))
            if (options_.force || !folder_.is_current(file, figure.inputs))
                figure.due.push_back(file);
        figures_.push_back(std::move(figure));
    }

    // The recorded caption and alternative text of a figure if they are up to date with its inputs,
    // else null.
    const WrittenWords* words_there(const PlannedFigure& figure) const {
        const auto words = folder_.manifest().figures.find(figure.spec->name);
        const bool known =
            words != folder_.manifest().figures.end() && words->second.inputs == figure.inputs;
        return known ? &words->second : nullptr;
    }

    // Whether any part of the figure must be made.
    bool is_due(const PlannedFigure& figure) const {
        return figure.chosen && !(figure.due.empty() && words_there(figure));
    }

    void refuse_foreign() {
        std::vector<std::string> files;
        for (const PlannedFigure& figure : figures_)
            if (figure.chosen) files.insert(files.end(), figure.due.begin(), figure.due.end());
        files.push_back(captions_name);
        for (const PageTemplate& page : set_.pages) files.push_back(set_.stem + page.ending);
        for (const SetPart& part : set_.parts)
            if (options_.films && !part.compares && !is_current_film(part))
                for (const auto& [what, file] : film_files(part)) files.push_back(file);
        report_.replaced = folder_.foreign(files);
        if (report_.replaced.empty() || options_.force) return;
        const bool one = report_.replaced.size() == 1;
        throw UsageError(fmt::format(
            "{}: carom did not write {}, or {} changed since; nothing has been written. Move {} "
            "away, or replace {} with --force",
            set_.folder.string(), listed(report_.replaced), one ? "it was" : "they were",
            one ? "it" : "them", one ? "it" : "them"));
    }

    // Checks a page before figures are made: for mistakes in the template, and for pictures that
    // neither exist nor are to be made.
    void refuse_page(const PageTemplate& page) const {
        page_text(set_, page, {}, {});
        for (const PlannedFigure& planned : figures_) {
            std::vector<std::string> files = files_there(planned);
            if (planned.chosen) files.insert(files.end(), planned.due.begin(), planned.due.end());
            if (planned.chosen || !files.empty())
                require_picture(set_, *planned.spec, files, page.kind);
        }
    }

    // The existing files of a figure that are up to date.
    std::vector<std::string> files_there(const PlannedFigure& planned) const {
        std::vector<std::string> files;
        for (const std::string& format : figure_formats())
            if (const std::string file = planned.spec->name + "." + format;
                folder_.is_current(file, planned.inputs))
                files.push_back(file);
        return files;
    }

    // The origin of a picture, stored in it in case it leaves its folder; `made from` is as in
    // figures.json.
    std::string origin_of(const PlannedFigure& planned) const {
        const Scene& scene = planned.part->scene;
        std::string origin = fmt::format("carom {}; {} {}; seed {}", CAROM_VERSION,
                                         planned.part->compares ? "figure" : "scene",
                                         as_utf8(planned.part->stem), scene.seed);
        if (!scene.source.overrides.empty())
            origin += fmt::format("; set {}", fmt::join(scene.source.overrides, " "));
        return origin + "; made from " + planned.inputs;
    }

    // Draws the figures of a scene that are due, from a run that measures nothing for the others.
    void draw(const SetPart& part) {
        std::vector<const PlannedFigure*> due;
        for (const PlannedFigure& figure : figures_) {
            if (figure.part != &part) continue;
            if (is_due(figure))
                due.push_back(&figure);
            else if (figure.chosen)
                ++report_.up_to_date;
        }
        if (due.empty()) return;
        report_.made += static_cast<int>(due.size());
        Progress progress(Progress::fitting_form(options_.quiet), part.stem);
        std::vector<std::string> names;
        for (const PlannedFigure* figure : due) names.push_back(figure->spec->name);
        const FigureRun run(part.scene, options_.threads, shown_runs(part.scene, progress), names);
        progress.begin("drawing", static_cast<double>(due.size()), "figures");
        std::vector<NewFile> files;
        for (const PlannedFigure* figure : due) {
            draw(run, *figure, files);
            progress.advance();
        }
        folder_.write(files);
    }

    void draw(const FigureRun& run, const PlannedFigure& planned, std::vector<NewFile>& files) {
        const std::string& name = planned.spec->name;
        const Figure& figure = *std::ranges::find_if(
            run.figures(), [&](const Figure& one) { return one.spec->name == name; });
        const FigureWords words = words_of(run, figure);
        for (const std::string& file : planned.due)
            files.push_back({file, bytes_of(run, figure, words, origin_of(planned), file), name,
                             planned.inputs});
        folder_.remember(name, {planned.inputs, words});
    }

    // The existing figures that are up to date with the scenes.
    std::vector<SetFigure> present() const {
        std::vector<SetFigure> all;
        for (const PlannedFigure& planned : figures_)
            if (const WrittenWords* words = words_there(planned))
                all.push_back({planned.part, planned.spec, words->words, files_there(planned)});
        return all;
    }

    bool is_current_film(const SetPart& part) const {
        const std::string inputs = inputs_of_film(part.scene);
        return std::ranges::all_of(film_files(part), [&](const auto& file) {
            return folder_.is_current(file.second, inputs);
        });
    }

    void render_film(const SetPart& part) {
        if (!options_.films || part.compares || (is_current_film(part) && !options_.force)) return;
        const auto files = film_files(part);
        Progress progress(Progress::fitting_form(options_.quiet), part.stem);
        const std::string inputs = inputs_of_film(part.scene);
        const FilmOptions options{
            .output = files.at("film"),
            .threads = options_.threads,
            .text = true,
            .take = [&](const FilmWriter& film) { folder_.write(film, files.at("film"), inputs); }};
        const FilmPlan plan = prepare(part.scene, options, progress);
        render(plan, options, progress);
        Canvas poster =
            draw_still(plan, time_of_poster(part.scene), output_format("png"), progress);
        std::vector<NewFile> beside{{files.at("poster"), poster.file(), "", inputs}};
        for (const auto& [what, ending] : text_endings)
            if (const auto file = files.find(what); file != files.end()) {
                const std::string text = text_for_file(plan.text, what);
                beside.push_back({file->second, {text.begin(), text.end()}, "", inputs});
            }
        folder_.write(beside);
        ++report_.films;
    }

    void write_words() {
        const std::vector<SetFigure> figures = present();
        std::vector<SetFilm> films;
        for (const SetPart& part : set_.parts)
            if (!part.compares && is_current_film(part)) films.push_back({&part, film_files(part)});
        std::vector<NewFile> files;
        const auto add = [&](const std::string& file, const std::string& text) {
            files.push_back({file, {text.begin(), text.end()}, "", ""});
        };
        add(captions_name, captions_json(set_.title, figures));
        for (const PageTemplate& page : set_.pages) {
            const std::string text = page_text(set_, page, figures, films);
            add(set_.stem + page.ending, text);
            if (page.kind != PageKind::latex) continue;
            if (auto letters = beyond_pdflatex(text); !letters.empty())
                report_.unset[set_.stem + page.ending] = std::move(letters);
        }
        folder_.write(files);
    }

    std::vector<std::string> gone() const {
        std::set<std::string> names;
        for (const PlannedFigure& figure : figures_) names.insert(figure.spec->name);
        std::vector<std::string> files;
        std::error_code error;
        for (const auto& [file, written] : folder_.manifest().files)
            if (!written.figure.empty() && !names.contains(written.figure) &&
                std::filesystem::exists(set_.folder / file, error))
                files.push_back(file);
        return files;
    }

    const FigureSet& set_;
    const SetOptions& options_;
    FigureFolder folder_;
    std::vector<PlannedFigure> figures_;
    SetReport report_;
};

}  // namespace

const FigureSpec* figure_spec(const Scene& scene, const std::string& name) {
    const auto found = std::ranges::find(scene.figures, name, &FigureSpec::name);
    return found == scene.figures.end() ? nullptr : &*found;
}

void refuse_same_names(const FigureSet& set) {
    std::map<std::string, const SetPart*> names;
    for (const SetPart& part : set.parts)
        for (const std::string& name : part.figures)
            if (const auto [first, added] = names.try_emplace(name, &part); !added)
                throw UsageError(fmt::format(
                    "{}: {} and {} both have a figure `{}`, and all go into one folder; give one "
                    "of them another name",
                    set.of, first->second->scene.source.path, part.scene.source.path, name));
    std::set<std::string> stems;
    for (const SetPart& part : set.parts)
        if (!part.compares && !stems.insert(part.stem).second)
            throw UsageError(
                fmt::format("{}: two of its scenes are called {}, and their films would be too; "
                            "list the scene once, or copy it to another name",
                            set.of, part.stem));
    std::set<std::string> endings;
    for (const PageTemplate& page : set.pages)
        if (!endings.insert(page.ending).second)
            throw UsageError(fmt::format("{}: two pages would be written to {}{}", set.of, set.stem,
                                         page.ending));
}

std::vector<std::filesystem::path> outputs_of(const FigureSet& set, const SetOptions& options) {
    std::vector<std::string> files{figures_manifest, captions_name};
    for (const PageTemplate& page : set.pages) files.push_back(set.stem + page.ending);
    for (const SetPart& part : set.parts) {
        for (const std::string& name : part.figures)
            std::ranges::copy(figure_files(set, *figure_spec(part.scene, name)),
                              std::back_inserter(files));
        if (options.films && !part.compares)
            for (const auto& [what, file] : film_files(part)) files.push_back(file);
    }
    std::vector<std::filesystem::path> outputs;
    for (const std::string& file : files) outputs.push_back(set.folder / file);
    return outputs;
}

SetReport make_figures(const FigureSet& set, const SetOptions& options) {
    refuse_same_names(set);
    refuse_unknown(set, options.only);
    require_machine_resources(options.threads, 0);
    return Maker(set, options).make();
}

}  // namespace carom
