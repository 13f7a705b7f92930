// The particles that a panel shows, as chosen in the scene: their indices, names and colours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "physics/membership.h"

namespace carom {

/// The choices that the panel's `of` lists, in its order; if it lists none, one choice of all
/// particles.
std::vector<Chosen> choices(const PanelSpec& spec);

/// The indices of the particles that are chosen at the start, in ascending order.
std::vector<Eigen::Index> members(const PanelContext& context, const Chosen& chosen);
std::vector<std::vector<Eigen::Index>> members(const PanelContext& context,
                                               const std::vector<Chosen>& chosen);

/// The same without particles of infinite mass, whose velocities collisions do not change; a choice
/// that has only such particles keeps them.
std::vector<std::vector<Eigen::Index>> members_that_collide(const PanelContext& context,
                                                            const std::vector<Chosen>& chosen);

/// The particles of some choices in the course of a run, as its samples say: those of a species are
/// the ones that belong to it at the time, and what is absent is in no choice. They are looked for
/// again only where the membership changes. Not thread-safe: each pass of a panel has its own.
class Members {
  public:
    /// As at the start. The particles of the context must outlive the object.
    Members(const PanelContext& context, std::vector<Chosen> chosen);

    /// Takes the next sample, in order of time. Returns whether its membership differs from that of
    /// the sample before (of the first: from that of the start). Flights up to this sample belong
    /// to the membership before.
    bool see(const Sample& sample);

    /// The indices of the particles of each choice at the last sample seen, in ascending order.
    const std::vector<std::vector<Eigen::Index>>& lists() const { return lists_; }

    /// see(), then lists().
    const std::vector<std::vector<Eigen::Index>>& at(const Sample& sample) {
        see(sample);
        return lists_;
    }

    /// Whether each particle is in a choice; empty: all are.
    std::vector<bool> flags(std::size_t choice) const;

    /// Writes or reads the membership of the last sample seen.
    void archive(Archive& archive);

  private:
    void find();

    const Particles* particles_;
    std::vector<Chosen> chosen_;
    MembershipWatch membership_;
    std::vector<std::vector<Eigen::Index>> lists_;
};

/// The length of trail that the scene asks for, in seconds of film: as given for the particle's
/// species, or else for the film; none if neither gives one.
std::optional<double> asked_trail(const Scene& scene, const Particles& particles,
                                  Eigen::Index particle);

/// Whether this is the only particle of its species among many others, and so the subject of the
/// film.
bool is_single_among_many(const Scene& scene, const Particles& particles, Eigen::Index particle);

/// The name of a choice: "all", the species' name, or "particle 3". column_name_of() gives it in
/// English, for tables.
std::string name_of(const Scene& scene, const Chosen& chosen);
std::string column_name_of(const Scene& scene, const Chosen& chosen);

/// For a particle that is the only one of its species: its label, or the species' name if it has
/// none. Empty for all others.
std::string single_name(const PanelContext& context, Eigen::Index particle);

/// The opacity of such a name, from 0 to 1. A film shows names during its first three seconds only.
double name_alpha(const PanelContext& context, const Tick& tick);

/// The colour of a species wherever species are distinguished by colour: the one given in the
/// scene, or else the default for its index.
plot::Role species_role(const PanelContext& context, std::size_t species);

/// The colour of one of several choices: for a species, that of species_role(); for single
/// particles and for "all", a colour that no species has by default. `place`: index among the
/// choices.
plot::Role choice_role(const PanelContext& context, const Chosen& chosen, std::size_t place);

/// The same, but a single choice has the colour of bars.
plot::Role role_among(const PanelContext& context, const std::vector<Chosen>& chosen,
                      std::size_t place);

/// Joins texts to one: "light and heavy", or with commas only.
enum class Joint { last_by_and, commas };
plot::Text joined(Language language, const std::vector<plot::Text>& texts,
                  Joint joint = Joint::last_by_and);

/// The names of choices in their colours: "light and heavy", "particles 3 and 7". A single name is
/// not coloured.
plot::Text names_of(const PanelContext& context, const std::vector<Chosen>& chosen,
                    plot::Swatch swatch, Joint joint = Joint::last_by_and);

/// What is shown, with the names of the choices: "Temperature of light and heavy".
plot::Text shown_of(const PanelContext& context, const plot::Text& what,
                    const std::vector<Chosen>& chosen, plot::Swatch swatch);

}  // namespace carom
