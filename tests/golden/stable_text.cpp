// SPDX-License-Identifier: Apache-2.0
#include "golden/stable_text.h"

#include <hawser/machine.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace hawser::golden {

namespace {

using nlohmann::json;

/// Volatile part of a text. A pattern is literal, with three exceptions: '#' is a number, '@' a
/// word, and '*' at its end the rest of the line. A part that matches is replaced by the pattern.
struct Pattern {
    std::string_view text;
    bool whole_line = false;  ///< Delete the line instead of the part.
};

constexpr std::array<Pattern, 24> kPatterns{{
    // Report of `run`: times, memory, machine, rounding errors of the solution.
    {", # s of wall time*"},
    {"step         median*"},
    {"wall, cpu    *"},
    {"stepping CPU *"},
    {"stages [ms]  *"},
    {"; in # steps, at most # ms"},
    {"residuals    *"},
    {"natural map p50 #, p95 #, max #"},
    {"state hash   *"},
    {"machine      *"},
    {", other @ @"},
    {"(# % of the exchanged energy)"},
    // Progress on the terminal, which depends on the clock.
    {" s  #x real time", true},
    // Times of other commands.
    {"; @ still moves at # m/s"},
    {" frames in # s, # frames/s"},
    {" failed, # s"},
    {"time             # us*"},
    {"memory           # MB"},
    {"METIS nested dissection*"},
    {" steps, last @"},
    // Panels of `figures`; the size of the font follows the length of the text.
    {"<text x=\"28\" y=\"76\" font-size=@ fill=@ = *"},
    {"   factor *"},
    {"factorisation # ms"},
    {"less accurate than 1e-8 *"},
}};

/// Members of JSON documents that are volatile, by key.
constexpr std::array<std::string_view, 21> kMembers{
    "wall_seconds",       "step_ms",         "solver_ms",      "solver_cpu_ms",
    "step_cpu_ms",        "stage_ms",        "ms_max",         "residuals",
    "state_hash",         "instruction_set", "processor",      "processors",
    "load_average",       "version",         "generator",      "peak_memory_bytes",
    "world_memory_bytes", "factor_ms",       "part_factor_ms", "drift",
    "step_drift"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Return the length of the number that begins at a position; 0 if there is none.
std::size_t number_length(std::string_view text, std::size_t at) {
    const std::size_t sign = at < text.size() && (text[at] == '-' || text[at] == '+') ? 1 : 0;
    if (at + sign >= text.size() || !is_digit(text[at + sign])) return 0;
    if (at > 0 && is_word(text[at - 1])) return 0;
    double value = 0.0;
    const char* from = text.data() + at + sign;
    const auto end = std::from_chars(from, text.data() + text.size(), value);
    return sign + static_cast<std::size_t>(end.ptr - from);
}

/// Return the length of the part at a position that a pattern matches; npos if it does not match.
std::size_t match_length(std::string_view text, std::size_t at, std::string_view pattern) {
    std::size_t i = at;
    for (const char p : pattern) {
        if (p == '*') {
            i = std::min(text.find('\n', i), text.size());
        } else if (p == '#') {
            std::size_t length = number_length(text, i);
            if (length == 0) return std::string_view::npos;
            i += length;
        } else if (p == '@') {
            while (i < text.size() && text[i] != ' ' && text[i] != '\n') ++i;
        } else if (i < text.size() && text[i] == p) {
            ++i;
        } else {
            return std::string_view::npos;
        }
    }
    return i - at;
}

void replace_pattern(std::string& text, const Pattern& pattern) {
    const std::string_view literal = pattern.text.substr(0, pattern.text.find_first_of("#@*"));
    for (std::size_t at = text.find(literal); at != std::string::npos;
         at = text.find(literal, at + 1)) {
        const std::size_t length = match_length(text, at, pattern.text);
        if (length == std::string_view::npos) continue;
        if (!pattern.whole_line) {
            text.replace(at, length, pattern.text);
            at += pattern.text.size() - 1;
            continue;
        }
        const std::size_t begin = text.rfind('\n', at) + 1;  // 0 in the first line
        text.erase(begin, std::min(text.find('\n', at), text.size() - 1) + 1 - begin);
        if (begin >= text.size()) break;
        at = begin;
    }
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

void prune(json& value) {
    if (value.is_object())
        for (const std::string_view member : kMembers) value.erase(std::string(member));
    if (value.is_structured())
        for (json& part : value) prune(part);
}

/// True if two numbers differ by no more than the tolerance. Whole numbers must be equal.
bool same_number(std::string_view a, std::string_view b, const NumberTolerance& tolerance) {
    if (a == b) return true;
    const auto whole = [](std::string_view n) { return n.find_first_of(".e") == n.npos; };
    if (whole(a) && whole(b)) return false;
    const auto value = [](std::string_view n) {
        double v = 0.0;
        const std::size_t plus = n.front() == '+' ? 1 : 0;
        std::from_chars(n.data() + plus, n.data() + n.size(), v);
        return v;
    };
    const double x = value(a), y = value(b);
    const double larger = std::max(std::abs(x), std::abs(y));
    return std::abs(x - y) <= std::max(tolerance.absolute, tolerance.relative * larger);
}

/// Skip the spaces before two numbers that differ. The padding of table columns depends on the
/// lengths of the numbers.
void skip_padding(std::string_view a, std::size_t& i, std::string_view b, std::size_t& j) {
    const std::size_t p = a.find_first_not_of(' ', i), q = b.find_first_not_of(' ', j);
    if (p == a.npos || q == b.npos || p == i || q == j) return;
    const std::size_t m = number_length(a, p), n = number_length(b, q);
    if (m == 0 || n == 0 || a.substr(p, m) == b.substr(q, n)) return;
    i = p;
    j = q;
}

constexpr std::size_t kSame = std::string_view::npos;

/// Return the position at which two lines differ; kSame if they do not.
std::size_t first_difference(std::string_view a, std::string_view b,
                             const NumberTolerance& tolerance) {
    if (a == b) return kSame;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        skip_padding(a, i, b, j);
        const std::size_t m = number_length(a, i), n = number_length(b, j);
        if (m > 0 && n > 0) {
            if (!same_number(a.substr(i, m), b.substr(j, n), tolerance)) return i;
            i += m;
            j += n;
        } else if (a[i] == b[j]) {
            ++i;
            ++j;
        } else {
            return i;
        }
    }
    return i == a.size() && j == b.size() ? kSame : i;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Return the part of a line around a position.
std::string_view about(std::string_view line, std::size_t at) {
    constexpr std::size_t kBefore = 60, kLength = 180;
    return line.substr(std::min(line.size(), at < kBefore ? 0 : at - kBefore), kLength);
}

}  // namespace

std::string stable_text(std::string text, const std::string& folder) {
    replace_all(text, folder, "$OUT");
    replace_all(text, std::string("awser ") + version(), "awser VERSION");
    for (const Pattern& pattern : kPatterns) replace_pattern(text, pattern);
    return text;
}

std::string stable_json(const std::string& text, const std::string& folder) {
    json document = json::parse(text);
    prune(document);
    return stable_text(document.dump(1) + "\n", folder);
}

std::string compare_texts(std::string_view reference, std::string_view text,
                          const NumberTolerance& tolerance) {
    const std::vector<std::string_view> a = lines_of(reference), b = lines_of(text);
    constexpr int kMaximum = 8;
    std::string out;
    int count = 0;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const std::string_view expected = i < a.size() ? a[i] : "(no line)";
        const std::string_view found = i < b.size() ? b[i] : "(no line)";
        const std::size_t at = first_difference(expected, found, tolerance);
        if (at == kSame || ++count > kMaximum) continue;
        out += fmt::format("  line {}:\n    - {}\n    + {}\n", i + 1, about(expected, at),
                           about(found, at));
    }
    if (count > kMaximum) out += fmt::format("  and {} lines more\n", count - kMaximum);
    return out;
}

}  // namespace hawser::golden
