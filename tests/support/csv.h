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

/// What stands between the commas of a line; none may be quoted.
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

/// The rows of tests/reference/NAME as text cells, without comments and the line of titles.
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

}  // namespace carom::test
