// A YAML document as a small tree that remembers the place of each value in its source. Independent
// of YAML syntax (yaml.h) and of the keys of scenes (keys.h).
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "util/diagnostics.h"

namespace carom {

/// Where a value was written. Of two values that cannot be combined, the one of the later origin
/// wins.
enum class Origin { preset, template_file, scene, command_line };

/// A text that nodes are read from. Nodes point to it, so it must outlive them.
struct Source {
    std::string name = {};  ///< as messages call it
    std::string text = {};
    Origin origin = Origin::scene;
};

/// A deque, so that the addresses of its sources stay valid as it grows.
using Sources = std::deque<Source>;

struct Node {
    enum class Kind { null, scalar, list, mapping };

    Kind kind = Kind::null;
    bool quoted = false;  ///< a scalar in quotes, or a block of text: never a number or a flag
    bool valid = true;    ///< the check sets it to false; readers treat an invalid value as absent
    const Source* source = nullptr;
    std::size_t offset = 0;    ///< byte in the source's text; for an empty value, that of its key
    std::string text = {};     ///< for a scalar
    std::string written = {};  ///< the text before its unit was converted; empty: as in `text`
    std::vector<Node> items = {};  ///< for a list, its items; for a mapping, its values
    std::vector<Node> keys = {};   ///< for a mapping: scalars, one for each of `items`

    bool is_scalar() const { return kind == Kind::scalar; }
    bool is_list() const { return kind == Kind::list; }
    bool is_mapping() const { return kind == Kind::mapping; }
};

/// Returns the value of `key` in a mapping, valid or not; null if the key is not given.
const Node* find(const Node& mapping, std::string_view key);
Node* find(Node& mapping, std::string_view key);

/// Makes a node and all in it point to another copy of its source.
void point_to(Node& node, const Source& source);

/// Removes a key of a mapping, by its index, with its value.
void erase_key(Node& mapping, std::size_t index);
/// Removes every key of this name from a mapping.
void erase_key(Node& mapping, std::string_view key);

/// Returns a description of a node for messages: `abc`, a list of 3, a mapping, nothing.
std::string described(const Node& node);

/// Returns `text` in backquotes, cut to 40 characters and made printable (util/text.h).
std::string in_quotes(std::string_view text);

/// Collects the errors of a scene, found in any order, and notes on what is accepted although it
/// should be written in another way.
class Errors {
  public:
    /// Adds an error at `node`, with what to write instead.
    void add(const Node& node, std::string message, std::string hint);

    /// Adds an error at a byte of a source where there is no node, or for the whole source.
    void add(const Source& source, std::size_t offset, std::string message, std::string hint);
    void add(const Source& source, std::string message, std::string hint);

    /// Adds a note at `node`: no error, but worth knowing.
    void add_note(const Node& node, std::string message, std::string hint);

    bool empty() const { return found_.empty(); }

    /// Returns the notes in the order of their places in the sources.
    std::vector<Diagnostic> notes() const;

    /// Returns whether so many errors have been kept that further ones are only counted: their
    /// messages need not be composed.
    bool is_full() const;

    /// Throws a SceneError with all errors, in the order of their places in the sources, if there
    /// are any.
    void throw_if_any() const;

  private:
    struct Found {
        const Source* source;
        std::size_t offset;  ///< npos: the whole source
        std::size_t bytes;   ///< length of the marked text
        std::string message, hint;
    };
    void add(Found found);
    static std::vector<Diagnostic> in_order(std::vector<Found> found, std::size_t most);

    std::vector<Found> found_, notes_;
    std::size_t unlisted_ = 0;  ///< number of errors beyond those kept
};

/// Returns the place of a node as a Diagnostic with an empty message, for errors that are found
/// later.
Diagnostic place_of(const Node& node);

}  // namespace carom
