#include "films/words/film_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "films/words/film_notes.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "physics/mechanics.h"
#include "scene/describe.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "scene/time/captions.h"
#include "scene/time/timeline.h"
#include "stats/speed_classes.h"
#include "util/files/atomic_file.h"
#include "util/formula/formula.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

// After a silence of this length a sound is captioned again.
constexpr double silent_seconds = 3.0;

double seconds_at(int frame, const Scene& scene, const FrameSpan& span) {
    return static_cast<double>(frame - span.first) / scene.film.fps;
}

// The first frame, from `first` on, that shows the same time as `frame`.
int when_it_stopped(const std::vector<Tick>& ticks, int frame, int first) {
    const auto time = [&](int i) { return ticks[static_cast<std::size_t>(i)].time; };
    while (frame > first && time(frame - 1) == time(frame)) --frame;
    return frame;
}

// Whether at this moment only the picture changes, not the gas: then no chapter begins.
bool is_note(const Moment& moment) {
    return !moment.notes.empty() && moment.events.empty() && moment.mark.empty() &&
           moment.caption.empty() && moment.end_card.empty() && !moment.reversed;
}

// Describes a pause; pauses that would take too much of the film were shortened.
std::string words_of_pause(const Film& film, const Pause& pause, int frames) {
    const bool is_whole = frames == static_cast<int>(std::lround(pause.seconds * film.fps));
    const double seconds = is_whole ? pause.seconds : std::round(100.0 * frames / film.fps) / 100.0;
    if (seconds == 1.0) return say(film.language, "The film pauses for a second");
    return say(film.language, "The film pauses for {} seconds",
               plain_number(film.language, seconds));
}

// The moments at which something happens, and quarters of the film that are not near these. Always
// includes the first frame and that of the end.
std::vector<Moment> moments_of(const Scene& scene, const FrameSpan& span,
                               const std::vector<Tick>& ticks) {
    std::vector<Moment> found;
    const auto at = [&](int frame) -> Moment& {
        const auto known = std::ranges::find(found, frame, &Moment::frame);
        if (known != found.end()) return *known;
        found.push_back({.frame = frame});
        found.back().time = ticks[static_cast<std::size_t>(frame)].time;
        return found.back();
    };
    for (int i = span.first + 1; i < span.end; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (ticks[k].reversals > ticks[k - 1].reversals)
            at(when_it_stopped(ticks, i, span.first)).reversed = true;
    }
    for (const CaptionSpan& caption : caption_schedule(scene))
        if (!caption.words.empty() && caption.first <= caption.last && caption.last >= span.first &&
            caption.first < span.end)
            at(std::max(caption.first, span.first)).caption =
                formula::spoken_text(scene.film.language, caption.words);
    // The first frame of the span that shows what happens at `time`, if there is one.
    const auto shown_from = [&](double time) {
        const auto shown = std::ranges::find_if(ticks, [&](const Tick& tick) {
            return tick.frame >= span.first && tick.time >= time && !is_card(tick.phase);
        });
        return shown != ticks.end() && shown->frame < span.end ? std::optional(shown->frame)
                                                               : std::nullopt;
    };
    for (const Mark& mark : scene.marks)
        if (const auto frame = shown_from(mark.at)) at(*frame).mark = mark.words;
    const double begins = ticks[static_cast<std::size_t>(span.first)].time;
    for (const FilmNote& note : film_notes(scene, ticks))
        if (const auto frame = shown_from(note.at);
            frame && (note.at >= begins || note.until > begins))
            at(*frame).notes.push_back(note.words);
    const auto add = [&](double time, const std::string& words) {
        if (time < begins) return;
        if (const auto frame = shown_from(time)) at(*frame).events.push_back(words);
    };
    for (const RunEvent& event : scene.run.events)
        if (const auto* moved = perturbation_of(event))
            add(event.at, words_of(wording_of(scene), *moved));
    const std::vector<int> pauses = pause_frames(scene.film);
    for (std::size_t k = 0; k < pauses.size(); ++k)
        add(scene.film.pauses[k].at, words_of_pause(scene.film, scene.film.pauses[k], pauses[k]));
    for (const Happening& one : happenings(wording_of(scene), scene.run, scene.gas))
        add(one.at, one.words);
    const auto card = std::ranges::find(ticks, Phase::end_card, &Tick::phase);
    if (card != ticks.end() && card->frame < span.end)
        at(card->frame).end_card = formula::spoken_text(scene.film.language, scene.film.end_card);
    at(span.first).is_title = is_card(ticks[static_cast<std::size_t>(span.first)].phase);
    const auto gas = std::ranges::find_if(
        ticks, [&](const Tick& tick) { return tick.frame >= span.first && !is_card(tick.phase); });
    if (gas != ticks.end() && gas->frame < span.end) at(gas->frame);
    const int end = when_it_stopped(ticks, span.end - 1, span.first);
    at(end).ends = true;
    for (int quarter = 1; quarter < 4; ++quarter) {
        const int frame = span.first + quarter * span.frames() / 4;
        const auto is_near = [&](const Moment& other) {
            return std::abs(other.frame - frame) < span.frames() / 8;
        };
        if (frame < end && std::ranges::none_of(found, is_near)) at(frame);
    }
    std::ranges::sort(found, {}, &Moment::frame);
    return found;
}

std::string time_of(const Moment& moment, const Scene& scene) {
    const Language language = scene.film.language;
    return say(language, "Time {}", three_digits(language, folded_time(scene.run, moment.time)));
}

// "Time 6 of 12, 207 collisions so far. Mean speed 1.40, mean energy 2.24: ..."
std::string numbers_of(const Moment& moment, const Scene& scene) {
    const Language language = scene.film.language;
    std::string text = time_of(moment, scene);
    if (scene.run.events.empty())
        text = say(language, "{} of {}", text, three_digits(language, scene.run.until));
    text = say(language, "{}, {} so far.", text,
               counted(language, moment.collisions, Phrase{"{} collision between particles"},
                       Phrase{"{} collisions between particles"}));
    if (!moment.surfaces.empty()) text += " " + moment.surfaces;
    if (!std::isfinite(moment.mean_energy)) return text;
    text += " " + say(language, "Mean speed {}, mean energy {}",
                      three_digits(language, moment.mean_speed),
                      three_digits(language, moment.mean_energy));
    std::vector<std::string> shares;
    for (std::size_t k = 0; k < moment.species_energy.size(); ++k)
        shares.push_back(fmt::format("{} {}", scene.gas.species[k].name,
                                     three_digits(language, moment.species_energy[k])));
    if (shares.size() > 1) text += " (" + listed(language, shares) + ")";
    const auto percent = [&](std::size_t k) { return std::lround(100.0 * moment.shares.at(k)); };
    return say(language, "{}; {} % slow, {} % medium and {} % fast.", text, percent(0), percent(1),
               percent(2));
}

Phrase coloring(const Scene& scene) {
    switch (scene.film.color_by) {
        case ColorBy::species:
            return Phrase{"The colour of a particle shows its species."};
        case ColorBy::speed_class:
            return Phrase{"The colour of a particle shows whether it is slow, medium or fast."};
        case ColorBy::mass:
            return Phrase{"The colour of a particle shows its mass."};
        case ColorBy::direction:
            return Phrase{"The colour of a particle shows the direction of its motion."};
        case ColorBy::energy:
            return Phrase{"The colour of a particle shows its energy."};
        case ColorBy::speed:
            break;
    }
    return Phrase{"The colour of a particle shows its speed."};
}

std::string on_one_line(std::string words) {
    std::ranges::replace(words, '\n', ' ');
    return words;
}

// Describes what the picture shows next to the gas.
std::string picture_text(const Scene& scene, bool has_sound) {
    const Language language = scene.film.language;
    std::vector<std::string> panels;
    for (const PanelSpec& panel : scene.film.panels) panels.push_back(name_of_panel(scene, panel));
    std::string text = say(language, coloring(scene));
    if (!panels.empty())
        text += " " + say(language, "Shown with the particles: {}.", listed(language, panels));
    for (const PanelSpec& panel : scene.film.panels)
        if (const PanelKind& kind = kind_of(panel); kind.text)
            text += " " + say(language, "The panel “{}” reads: “{}”", name_of_panel(scene, panel),
                              on_one_line(formula::spoken_text(language, kind.text(panel))));
    if (has_sound)
        text +=
            " " +
            say(language,
                "Each collision is heard as a click, higher in pitch where the impulse is larger.");
    const bool is_described = scene.description == describe(scene);
    for (const std::string& words : words_of_surfaces(wording_of(scene), scene.gas))
        if (!is_described) text += " " + words + ".";
    return text;
}

// What is seen or happens at a moment, as text for a description.
std::string happening(Language language, const Moment& moment) {
    std::string text;
    if (moment.ends) text += say(language, "The film ends.") + " ";
    if (moment.reversed) text += say(language, "All velocities are reversed.") + " ";
    for (const std::string& event : moment.events) text += event + ". ";
    for (const std::string& note : moment.notes) text += note + ". ";
    if (!moment.mark.empty())
        text += say(language, "The positions of all particles stay visible as outlines: “{}”.",
                    moment.mark) +
                " ";
    if (!moment.end_card.empty())
        text += say(language, "The closing sentence: “{}”.", moment.end_card) + " ";
    return text;
}

// The title of the chapter that begins at a moment.
std::string heading(const Moment& moment, const Scene& scene) {
    if (!moment.caption.empty()) return moment.caption;
    if (!moment.end_card.empty()) return moment.end_card;
    if (moment.is_title) return scene.title;
    if (moment.reversed) return say(scene.film.language, "Velocities reversed");
    if (!moment.events.empty()) return moment.events.front();
    if (!moment.mark.empty()) return moment.mark;
    if (moment.time == 0.0) return say(scene.film.language, "The start");
    return time_of(moment, scene);
}

std::string description_of(const Moment& moment, const Scene& scene, const FrameSpan& span,
                           bool has_sound) {
    std::string text;
    if (moment.frame == span.first) {
        text = sentence(scene.title) + " ";
        if (!scene.subtitle.empty()) text += sentence(scene.subtitle) + " ";
        text += sentence(scene.description) + " " + picture_text(scene, has_sound) + " ";
    }
    text += happening(scene.film.language, moment);
    if (!moment.end_card.empty()) return text;
    return text + numbers_of(moment, scene);
}

// What happens at each moment, with times. A film that is part of another begins there at second
// `before`.
std::vector<Cue> passages_of(const Scene& scene, const std::vector<Moment>& moments,
                             const FrameSpan& span, double before) {
    std::vector<Cue> passages;
    for (const Moment& moment : moments) {
        const double start = before + seconds_at(moment.frame, scene, span);
        std::string text = happening(scene.film.language, moment);
        if (!moment.caption.empty()) text += say(scene.film.language, "“{}”", moment.caption) + " ";
        if (moment.end_card.empty()) text += numbers_of(moment, scene);
        while (text.ends_with(' ')) text.pop_back();
        passages.push_back({start, start, text});
    }
    return passages;
}

// "A silent film of 0:30.", or its place in another.
std::string length_text(const Scene& scene, const FrameSpan& span, std::optional<double> joined_at,
                        bool has_sound) {
    const double before = joined_at.value_or(0.0);
    const double length = static_cast<double>(span.frames()) / scene.film.fps;
    const Language language = scene.film.language;
    if (!joined_at)
        return has_sound ? say(language, "A film of {} with sound.", clock_text(length))
                         : say(language, "A silent film of {}.", clock_text(length));
    return say(language, "From {} to {}.", clock_text(before), clock_text(before + length));
}

std::string transcript_of(const Scene& scene, const std::string& length, bool has_sound,
                          const std::vector<Cue>& passages) {
    std::string text = scene.title + "\n";
    if (!scene.subtitle.empty()) text += scene.subtitle + "\n";
    text += fmt::format("\n{}\n\n{}\n{}\n", length, sentence(scene.description),
                        picture_text(scene, has_sound));
    for (const Cue& passage : passages)
        text += fmt::format("\n{}  {}\n", clock_text(passage.start), passage.words);
    return text;
}

// The caption for clicks from second `first` to `last`, in a film that ends at `end`.
Cue sound_caption(double first, double last, double end, Language language) {
    constexpr double least = 2.0, most = 5.0;  // seconds for which it is shown
    return {first, std::min(end, std::clamp(last, first + least, first + most)),
            say(language, "[clicks: one for each collision, higher where the impulse is larger]")};
}

std::string stamp(double seconds) {
    const auto milliseconds = static_cast<long long>(std::llround(1000.0 * seconds));
    return fmt::format("{:02}:{:02}:{:02}.{:03}", milliseconds / 3'600'000,
                       milliseconds / 60'000 % 60, milliseconds / 1000 % 60, milliseconds % 1000);
}

// Escapes what would begin a tag or an escape sequence, and empty lines, which would end the cue.
// The arrow "-->" needs no further care, as its ">" is escaped.
std::string escaped(const std::string& words) {
    std::string text;
    for (const char letter : words) {
        if (letter == '\n' && (text.empty() || text.back() == '\n')) continue;
        if (letter == '&')
            text += "&amp;";
        else if (letter == '<')
            text += "&lt;";
        else if (letter == '>')
            text += "&gt;";
        else
            text += letter;
    }
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

}  // namespace

std::string webvtt(const std::vector<Cue>& cues) {
    std::string file = "WEBVTT\n";
    for (const Cue& cue : cues) {
        const std::string words = escaped(cue.words), start = stamp(cue.start),
                          end = stamp(cue.end);
        if (!words.empty() && start < end)
            file += fmt::format("\n{} --> {}\n{}\n", start, end, words);
    }
    return file;
}

FilmTextMaker::FilmTextMaker(const Scene& scene, const FrameSpan& span,
                             const std::vector<Tick>& ticks, const Particles& particles,
                             std::optional<double> joined_at, bool has_sound)
    : scene_(scene),
      span_(span),
      particles_(particles),
      joined_at_(joined_at),
      has_sound_(has_sound),
      moments_(moments_of(scene, span, ticks)) {}

// Collisions that occur before a frame are heard during the preceding frame.
void FilmTextMaker::hear(const Tick& tick, const CollisionCounts& counts) {
    const std::int64_t so_far = counts.particle + counts.wall;
    const bool is_heard = so_far > std::exchange(collisions_, so_far);
    const FrameSpan its{tick.frame - 1, tick.frame};
    if (!is_heard || its.first < span_.first || its.end > span_.end) return;
    const int apart = static_cast<int>(silent_seconds * scene_.film.fps);
    if (heard_.empty() || its.first - heard_.back().end >= apart) heard_.push_back(its);
    heard_.back().end = its.end;
}

void FilmTextMaker::see(const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
    if (has_sound_) hear(tick, advanced.counts);
    if (next_ == moments_.size() || moments_[next_].frame != tick.frame) return;
    Moment& moment = moments_[next_++];
    const Eigen::ArrayXd speed = speeds(sample);
    const Eigen::ArrayXd energy = kinetic_energies(particles_, sample);
    moment.collisions = advanced.counts.particle;
    constexpr bool only_changes = true;
    moment.surfaces =
        words_at_present(scene_.film.language, scene_.gas, advanced.surfaces, only_changes);
    moment.mean_speed = mean_of_speeds(particles_, speed);
    moment.mean_energy = mean_over_finite_masses(particles_, energy);
    moment.shares = class_shares(speed, moment.mean_speed);
    for (std::size_t k = 0; k < scene_.gas.species.size(); ++k) {
        const Eigen::Array<bool, Eigen::Dynamic, 1> members =
            particles_.species == static_cast<int>(k);
        const double sum = members.select(energy, 0.0).sum();
        moment.species_energy.push_back(sum / static_cast<double>(members.count()));
    }
}

FilmText FilmTextMaker::text(const std::vector<std::string>& number_texts) {
    const auto fill = [&](std::string& words) {
        words = filled(words, [&](std::size_t number) { return number_texts.at(number); });
    };
    for (Moment& moment : moments_) {
        for (std::string* words : {&moment.caption, &moment.end_card}) fill(*words);
        for (std::string& words : moment.notes) fill(words);
    }
    const double begin = static_cast<double>(span_.first) / scene_.film.fps;
    const double end = seconds_at(span_.end, scene_, span_);
    std::vector<Cue> captions, chapters, descriptions;
    for (const CaptionSpan& caption : caption_schedule(scene_))
        captions.push_back({std::max(0.0, caption.start - begin),
                            std::min(end, caption.end - begin),
                            formula::spoken_text(scene_.film.language, caption.words)});
    for (const Moment& moment : moments_)
        if (!moment.end_card.empty())
            captions.push_back({seconds_at(moment.frame, scene_, span_), end, moment.end_card});
    for (const FrameSpan& heard : heard_)
        captions.push_back(sound_caption(seconds_at(heard.first, scene_, span_),
                                         seconds_at(heard.end, scene_, span_), end,
                                         scene_.film.language));
    std::ranges::stable_sort(captions, {}, &Cue::start);
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        const double start = seconds_at(moments_[i].frame, scene_, span_);
        const bool last = i + 1 == moments_.size();
        const double next = last ? end : seconds_at(moments_[i + 1].frame, scene_, span_);
        descriptions.push_back(
            {start, next, description_of(moments_[i], scene_, span_, has_sound_)});
        if ((moments_[i].ends || is_note(moments_[i])) && !chapters.empty())
            chapters.back().end = next;
        else
            chapters.push_back({start, next, heading(moments_[i], scene_)});
    }
    const double before = joined_at_.value_or(0.0);
    if (joined_at_) chapters = {{0.0, end, scene_.title}};
    for (std::vector<Cue>* cues : {&captions, &chapters, &descriptions})
        for (Cue& cue : *cues) {
            cue.start += before;
            cue.end += before;
        }
    const std::string length = length_text(scene_, span_, joined_at_, has_sound_);
    std::vector<Cue> passages = passages_of(scene_, moments_, span_, before);
    return {captions.empty() && !has_sound_ ? "" : webvtt(captions),
            webvtt(chapters),
            webvtt(descriptions),
            transcript_of(scene_, length, has_sound_, passages),
            chapters,
            length + " " + picture_text(scene_, has_sound_),
            passages};
}

bool has_captions(const Scene& scene) {
    return !caption_schedule(scene).empty() || !scene.film.end_card.empty() || scene.film.sound;
}

std::filesystem::path text_path(const std::filesystem::path& path, const std::string& what) {
    std::filesystem::path stem = path;
    if (!stem.has_filename())
        stem = stem.parent_path();  // frames/
    else
        stem.replace_extension();
    return stem.string() + text_endings.at(what);
}

std::string text_for_file(const FilmText& text, const std::string& what) {
    const std::string& words = what == "captions"       ? text.captions
                               : what == "chapters"     ? text.chapters
                               : what == "descriptions" ? text.descriptions
                                                        : text.transcript;
    return words.empty() ? webvtt({}) : words;
}

void commit_with_text(PendingOutput& film, const FilmText& text, TextFiles wanted,
                      const std::filesystem::path& path, PendingOutput* picture) {
    std::vector<PendingOutput*> outputs{&film};
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (const auto& [what, ending] : text_endings) {
        const bool is_wanted =
            wanted == TextFiles::all || (wanted == TextFiles::captions && what == "captions");
        const std::filesystem::path file = text_path(path, what);
        std::error_code error;
        // If there are no captions, earlier ones are emptied.
        const bool is_missing =
            what == "captions" && text.captions.empty() && !std::filesystem::exists(file, error);
        if (!is_wanted || is_missing) continue;
        outputs.push_back(files.emplace_back(std::make_unique<AtomicFile>(file)).get());
        files.back()->write(text_for_file(text, what));
    }
    if (picture != nullptr) outputs.push_back(picture);
    commit_together(outputs);
}

}  // namespace carom
