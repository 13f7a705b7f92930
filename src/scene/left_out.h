// What a scene shows or does after an earlier end of its run that the command line sets.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/yaml/node.h"

namespace carom {

/// Items of lists of a scene, by the key of the list and their index in it: the panels, monitors,
/// callouts, spotlights, moves of the camera and slow motion of the film, and the figures; also the
/// film's second run, with index 0.
using ListItems = std::set<std::pair<std::string, std::size_t>>;

/// Returns the end of the run if the command line sets it; otherwise null.
const Node* end_set_by_command_line(const Node& root);

/// Adds the items in which all of these errors lie. Returns false, and adds nothing, if an error
/// lies elsewhere, in what the command line sets, or in an item that is contained already.
bool add_items_with(const std::vector<Diagnostic>& errors, const Node& root, ListItems& items);

/// What has been removed from a scene's lists, in words: "2 figures (`early` and `late`)".
using Removed = std::vector<std::string>;

/// Removes items from the lists of a scene's tree.
Removed remove_items(Node& root, const ListItems& items);

/// If the command line ends the run of a scene at a time, removes later events and moments of
/// strips from its tree and ends slow motion with the run. Adds a note to `notes`, unless it is
/// null, that lists these and what has been removed before. Parts of the tree that do not have the
/// expected form are left as they are.
void leave_out_later(Node& root, const Removed& before, Errors* notes);

}  // namespace carom
