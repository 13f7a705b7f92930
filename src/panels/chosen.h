// The particles that a panel shows, as its scene chose them: which, their name, their colour.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"

namespace carom {

/// What the panel's `of` names, in its order; all particles where it names none.
std::vector<Chosen> choices(const PanelSpec& spec);

/// Numbers of the particles chosen, rising.
std::vector<Eigen::Index> members(const PanelContext& context, const Chosen& chosen);
std::vector<std::vector<Eigen::Index>> members(const PanelContext& context,
                                               const std::vector<Chosen>& chosen);

/// The same of those that collisions can turn: without infinite masses, but where there is nothing
/// else.
std::vector<std::vector<Eigen::Index>> members_that_collide(const PanelContext& context,
                                                            const std::vector<Chosen>& chosen);

/// How long a trail the scene asks for, in seconds of film, by the particle's species or else for
/// the film; nothing where it does not say.
std::optional<double> asked_trail(const Scene& scene, const Particles& particles,
                                  Eigen::Index particle);

/// Whether this is the only particle of its species, among many others: what a film is about.
bool is_single_among_many(const Scene& scene, const Particles& particles, Eigen::Index particle);

/// "all", the species' name, "particle 3"; in English for a table.
std::string name_of(const Scene& scene, const Chosen& chosen);
std::string column_name_of(const Scene& scene, const Chosen& chosen);

/// The label of a particle that is the only one of its species, or the species' name; empty for
/// others.
std::string single_name(const PanelContext& context, Eigen::Index particle);

/// How much of such a name is seen, from 0 to 1: in a film for its first three seconds.
double name_alpha(const PanelContext& context, const Tick& tick);

/// The colour in which a species is drawn wherever species are told apart: its own, or the set's.
plot::Role species_role(const PanelContext& context, std::size_t species);

/// The colour of a choice among several: the species', wherever it is told apart; single particles
/// and all have colours that no species has by default. `place`: among the choices.
plot::Role choice_role(const PanelContext& context, const Chosen& chosen, std::size_t place);

/// That of the only choice is the one of bars.
plot::Role role_among(const PanelContext& context, const std::vector<Chosen>& chosen,
                      std::size_t place);

/// Texts as one: "light and heavy", or with commas only.
enum class Joint { last_by_and, commas };
plot::Text joined(Language language, const std::vector<plot::Text>& texts,
                  Joint joint = Joint::last_by_and);

/// Names in their colours: "light and heavy", "particles 3 and 7"; uncoloured where there is one.
plot::Text names_of(const PanelContext& context, const std::vector<Chosen>& chosen,
                    plot::Sample sample, Joint joint = Joint::last_by_and);

/// "Temperature of light and heavy": what is shown, of those chosen.
plot::Text shown_of(const PanelContext& context, const plot::Text& what,
                    const std::vector<Chosen>& chosen, plot::Sample sample);

}  // namespace carom
