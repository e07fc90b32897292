// SPDX-License-Identifier: Apache-2.0
#include "record/control.h"

#include "base/file_kind.h"
#include "record/files.h"
#include "record/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hawser::record {

namespace {

struct Field {
    std::string_view text;
    std::size_t column = 1;  // Column of its first character, from 1.
};

std::vector<Field> split(std::string_view line) {
    std::vector<Field> out;
    for (std::size_t at = 0;;) {
        const std::size_t comma = line.find(',', at);
        std::string_view text = line.substr(at, comma - at);
        const std::size_t blanks = std::min(text.find_first_not_of(" \t"), text.size());
        text.remove_prefix(blanks);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
        out.push_back({text, at + blanks + 1});
        if (comma == std::string_view::npos) return out;
        at = comma + 1;
    }
}

class Parser {
  public:
    Parser(std::string_view text, const std::string& file, std::span<const std::string> inputs,
           std::span<const ControlRange> ranges)
        : text_(text), file_(file), inputs_(inputs), ranges_(ranges) {}

    void line(std::string_view line) {
        ++line_;
        if (line_ == 1 && line.starts_with("\xEF\xBB\xBF"))  // Written by some spreadsheets.
            line.remove_prefix(3);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_not_of(" \t,") == std::string_view::npos || line[0] == '#') return;
        if (columns_.empty())
            header(split(line));
        else
            values(split(line));
    }

    [[nodiscard]] std::vector<ControlChange> finish() {
        if (columns_.empty()) fail(1, "the first line must be time,<input>,…");
        return std::move(changes_);
    }

  private:
    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        throw ControlError(
            fmt::format("{}:{}:{}: {}", file_, std::max<std::size_t>(1, line_), column, message));
    }

    void header(const std::vector<Field>& fields) {
        if (fields[0].text != "time") {
            const std::string other = base::file_kind_error(text_, "a control file (CSV)", file_);
            if (!other.empty()) throw ControlError(file_ + ": " + other);
        }
        if (fields[0].text != "time")
            fail(fields[0].column,
                 fmt::format("the first column is \"{}\", expected \"time\"", fields[0].text));
        columns_.push_back(-1);
        for (std::size_t i = 1; i < fields.size(); ++i) {
            const auto found = std::find(inputs_.begin(), inputs_.end(), fields[i].text);
            if (found == inputs_.end()) fail(fields[i].column, unknown_name_error(fields[i].text));
            const auto input = static_cast<std::int32_t>(found - inputs_.begin());
            if (std::find(columns_.begin(), columns_.end(), input) != columns_.end())
                fail(fields[i].column,
                     fmt::format("the input \"{}\" has two columns", fields[i].text));
            columns_.push_back(input);
        }
        if (columns_.size() == 1)
            fail(fields[0].column, "there is no column besides time: " + choices());
    }

    [[nodiscard]] std::string choices() const {
        if (inputs_.empty()) return "the scene has no inputs";
        return "the scene's inputs are " + fmt::format("{}", fmt::join(inputs_, ", "));
    }

    [[nodiscard]] std::string unknown_name_error(std::string_view name) const {
        if (inputs_.empty())
            return fmt::format("unknown input \"{}\": the scene has no inputs", name);
        return fmt::format("unknown input \"{}\"; nearest: \"{}\"", name,
                           nearest_name(name, inputs_));
    }

    void values(const std::vector<Field>& fields) {
        if (fields.size() != columns_.size())
            fail(fields.back().column,
                 fmt::format("{} fields, the first line has {}", fields.size(), columns_.size()));
        const double time = number(fields[0]);
        if (!changes_.empty() && time < last_time_)
            fail(fields[0].column,
                 fmt::format("time {} is before the previous line's {}", time, last_time_));
        last_time_ = time;
        for (std::size_t i = 1; i < fields.size(); ++i)
            if (!fields[i].text.empty())
                changes_.push_back({time, columns_[i], value_of(columns_[i], fields[i])});
    }

    [[nodiscard]] double value_of(std::int32_t input, const Field& field) const {
        const double value = number(field);
        const auto i = static_cast<std::size_t>(input);
        if (!ranges_.empty() && !(value >= ranges_[i].min && value <= ranges_[i].max))
            fail(field.column,
                 fmt::format("{} is not within the range of the input \"{}\", {:.6g} to {:.6g}{}",
                             field.text, inputs_[i], ranges_[i].min, ranges_[i].max,
                             ranges_[i].unit.empty() || ranges_[i].unit == "1"
                                 ? ""
                                 : " " + ranges_[i].unit));
        return value;
    }

    [[nodiscard]] double number(const Field& field) const {
        double value = 0.0;
        const char* end = field.text.data() + field.text.size();
        // NOLINTNEXTLINE(bugprone-suspicious-stringview-data-usage): the call passes the end.
        const auto [at, error] = std::from_chars(field.text.data(), end, value);
        if (error != std::errc() || at != end || !std::isfinite(value))
            fail(field.column, fmt::format("\"{}\" is not a finite number", field.text));
        return value;
    }

    std::string_view text_;
    const std::string& file_;
    std::span<const std::string> inputs_;
    std::span<const ControlRange> ranges_;
    std::vector<std::int32_t> columns_;  // Input of each column; −1 for time.
    std::vector<ControlChange> changes_;
    std::size_t line_ = 0;
    double last_time_ = 0.0;
};

}  // namespace

std::vector<ControlChange> parse_control(std::string_view text, const std::string& file,
                                         std::span<const std::string> inputs,
                                         std::span<const ControlRange> ranges) {
    Parser parser(text, file, inputs, ranges);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        parser.line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return parser.finish();
}

std::vector<ControlChange> read_control(const std::filesystem::path& file,
                                        std::span<const std::string> inputs,
                                        std::span<const ControlRange> ranges) {
    std::string text;
    if (const std::string fault = read_file(file, text); !fault.empty())
        throw ControlError(fmt::format("{}: {}", file.string(), fault));
    return parse_control(text, file.string(), inputs, ranges);
}

}  // namespace hawser::record
