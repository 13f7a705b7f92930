#include "scene/keys/binding.h"

#include <algorithm>

namespace carom {

AnyBinding::AnyBinding(Key key_, ReadPart read_part_, std::ptrdiff_t offset_)
    : key(std::move(key_)), read_part(std::move(read_part_)), offset(offset_) {}
AnyBinding::AnyBinding(const AnyBinding&) = default;
AnyBinding::AnyBinding(AnyBinding&&) noexcept = default;
AnyBinding& AnyBinding::operator=(const AnyBinding&) = default;
AnyBinding& AnyBinding::operator=(AnyBinding&&) noexcept = default;
AnyBinding::~AnyBinding() = default;

void AnyBinding::read_into(void* object, const Node& node, Reading& reading) const {
    read_part(static_cast<char*>(object) + offset, node, reading);
}

std::ptrdiff_t binding::distance(const void* object, const void* part) {
    return static_cast<const char*>(part) - static_cast<const char*>(object);
}

struct AnyTable::Contents {
    struct Reader {
        AnyBinding::ReadPart read_part;
        std::ptrdiff_t offset;
        bool reads_default;
    };
    Section section;
    std::vector<Reader> readers;  // one for each key
    std::optional<Rule> rule;
};

AnyTable::AnyTable(Section section, std::vector<AnyBinding> keys, std::optional<Rule> rule) {
    Contents all{.section = std::move(section), .readers = {}, .rule = std::move(rule)};
    for (AnyBinding& binding : keys) {
        all.section.keys.push_back(std::move(binding.key));
        all.readers.push_back(
            {std::move(binding.read_part), binding.offset, binding.reads_default});
    }
    contents_ = std::make_shared<const Contents>(std::move(all));
}

const Section& AnyTable::section() const { return contents_->section; }

Form AnyTable::form(std::string phrase) const {
    return {.shape = Shape::mapping,
            .section = {contents_, &contents_->section},
            .phrase = std::move(phrase)};
}

void AnyTable::read_into(void* object, const Node& mapping, Reading& reading) const {
    const auto read = [&](const Contents::Reader& reader, const Node& node) {
        reader.read_part(static_cast<char*>(object) + reader.offset, node, reading);
    };
    for (std::size_t k = 0; k < contents_->readers.size(); ++k) {
        const Key& key = section().keys[k];
        const Contents::Reader& reader = contents_->readers[k];
        if (const Node* node = given(mapping, key.name))
            read(reader, *node);
        else if (reader.reads_default && find(mapping, key.name) == nullptr)
            read(reader, default_node(key.default_value));
    }
    if (contents_->rule) (*contents_->rule)(object, mapping, reading);
}

bool AnyTable::is_complete(const Node& mapping) const {
    return std::ranges::all_of(section().keys, [&](const Key& key) {
        return !key.required || given(mapping, key.name) != nullptr;
    });
}

}  // namespace carom
