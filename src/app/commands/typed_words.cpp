#include "app/commands/typed_words.h"

#include <cstddef>
#include <filesystem>
#include <system_error>

namespace carom {

std::vector<std::string> with_each_set(std::vector<std::string> words) {
    const auto is_change = [](const std::string& word) {
        std::error_code error;
        return !word.starts_with('-') && word.find('=') != std::string::npos &&
               !std::filesystem::exists(word, error);
    };
    for (std::size_t i = 2; i < words.size(); ++i)
        if (words[i - 2] == "--set" && is_change(words[i]))
            words.insert(words.begin() + static_cast<std::ptrdiff_t>(i++), "--set");
    return words;
}

void fill_absent_values(std::vector<std::string>& words, const std::vector<Option>& options) {
    const auto is_value = [](const std::string& word) {
        std::error_code error;
        return !word.starts_with('-') && !word.ends_with(".yaml") && !word.ends_with(".yml") &&
               !std::filesystem::is_regular_file(word, error);
    };
    for (const Option& option : options)
        for (std::size_t i = 0; !option.absent.empty() && i < words.size(); ++i)
            if (words[i] == flags_of(option) && (i + 1 == words.size() || !is_value(words[i + 1])))
                words[i] += "=" + option.absent;
}

}  // namespace carom
