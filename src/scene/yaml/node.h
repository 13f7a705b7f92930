// A YAML document as a small tree that remembers where each value stands in its source. Knows no
// YAML syntax (yaml.h) and no scene (keys.h).
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "util/diagnostics.h"

namespace carom {

/// Where a value was written; where two cannot be combined, the later origin wins.
enum class Origin { preset, template_file, scene, command_line };

/// A text that values stand in. Nodes point to it: it outlives them.
struct Source {
    std::string name = {};  ///< as messages call it
    std::string text = {};
    Origin origin = Origin::scene;
};

/// A deque, so that sources keep their address.
using Sources = std::deque<Source>;

struct Node {
    enum class Kind { null, scalar, list, mapping };

    Kind kind = Kind::null;
    bool quoted = false;  ///< a scalar in quotes, or a block of text: never a number or a flag
    bool valid = true;    ///< set false by the check; readers take an invalid value as absent
    const Source* source = nullptr;
    std::size_t offset = 0;        ///< byte in the source's text; of an empty value: its key's
    std::string text = {};         ///< of a scalar
    std::vector<Node> items = {};  ///< of a list; the values of a mapping
    std::vector<Node> keys = {};   ///< of a mapping: scalars, as many as items

    bool is_scalar() const { return kind == Kind::scalar; }
    bool is_list() const { return kind == Kind::list; }
    bool is_mapping() const { return kind == Kind::mapping; }
};

/// The value of `key` in a mapping as written, valid or not; null if there is none.
const Node* find(const Node& mapping, std::string_view key);
Node* find(Node& mapping, std::string_view key);

/// What a node is, for messages: `abc`, a list of 3, a mapping, nothing.
std::string described(const Node& node);

/// `text` in backquotes, cut to 40 characters, printable (util/text.h).
std::string in_quotes(std::string_view text);

/// The errors of a scene as they are found, in any order.
class Errors {
  public:
    /// An error at `node`.
    void add(const Node& node, std::string message, std::string hint = {});

    /// An error at a byte of a source that is no node, or at the whole source.
    void add(const Source& source, std::size_t offset, std::string message, std::string hint = {});
    void add(const Source& source, std::string message, std::string hint = {});

    bool empty() const { return found_.empty(); }

    /// Whether more errors are counted only, so that their words need not be made.
    bool is_full() const;

    /// Throws a SceneError with all errors in the order of the sources' text, if there are any.
    void throw_if_any() const;

  private:
    struct Found {
        const Source* source;
        std::size_t offset;  ///< npos: the whole source
        std::size_t bytes;   ///< of the marked text
        std::string message, hint;
    };
    void add(Found found);

    std::vector<Found> found_;
    std::size_t unlisted_ = 0;  ///< found beyond those kept
};

/// The place of a node with an empty message, for errors that are found later.
Diagnostic place_of(const Node& node);

}  // namespace carom
