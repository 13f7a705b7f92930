// Reads tables of numbers, such as those in tests/reference/.
#pragma once

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace carom::test {

/// Splits a line at its commas; quoted fields are not supported.
inline std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

/// The rows of tests/reference/NAME as text cells, without comments and without the header line.
inline std::vector<std::vector<std::string>> reference_rows(const std::string& name) {
    std::ifstream file(carom::test::checkout().string() + "/tests/reference/" + name);
    if (!file) throw std::runtime_error("no reference table " + name);
    std::vector<std::vector<std::string>> rows;
    bool titles = true;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (titles) {
            titles = false;
            continue;
        }
        rows.push_back(cells_of(line));
    }
    return rows;
}

/// The value of "3", "-1/2" or "0.25".
inline double fraction(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return std::stod(text);
    return std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

/// The rows of a text in the format of RFC 4180, with quoted fields. Throws if a quote is not
/// closed or if the last line does not end with a line break.
inline std::vector<std::vector<std::string>> quoted_rows(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
            rows.back().back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            rows.back().emplace_back();
        else if (c == '\n' && !quoted)
            rows.push_back({""});
        else
            rows.back().back() += c;
    }
    if (quoted || rows.back() != std::vector<std::string>{""})
        throw std::runtime_error("a table ends inside of a row");
    rows.pop_back();
    return rows;
}

}  // namespace carom::test
