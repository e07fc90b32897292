// SPDX-License-Identifier: Apache-2.0
#include "scene/read_json.h"

#include "base/file_kind.h"
#include "scene/mistakes.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <vector>

namespace hawser::scene {
namespace {

void check_text_kind(std::string_view text, const std::string& file, const char* expected) {
    const std::string other = base::file_kind_error(text, expected, file);
    if (!other.empty()) throw_error({file, ""}, other);
}
constexpr std::size_t kMostEntries = 2'000'000;  ///< Largest number of entries of an array.
constexpr std::size_t kMaxValues = 10'000'000;   ///< Largest number of values of a file.
constexpr std::size_t kMaxUnknown = 10'000;      ///< Largest number of values below an unknown key.

/// First pass over the text. Checks everything that the parser alone would accept.
class LimitChecker : public nlohmann::json_sax<Json> {
  public:
    LimitChecker(std::string file, const std::set<std::string>& keys, Mistakes* mistakes,
                 std::string_view text, const char* expected)
        : location_{std::move(file), ""},
          mistakes_(mistakes),
          text_(text),
          expected_(expected),
          keys_(keys) {}

    bool null() override { return next(); }
    bool boolean(bool) override { return next(); }
    bool number_integer(number_integer_t) override { return next(); }
    bool number_unsigned(number_unsigned_t) override { return next(); }
    bool number_float(number_float_t, const string_t&) override { return next(); }
    bool string(string_t&) override { return next(); }
    bool binary(binary_t&) override { return next(); }
    bool start_object(std::size_t) override { return open(true); }
    bool start_array(std::size_t) override { return open(false); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        Level& level = levels_.back();
        level.key = name;
        if (levels_.size() == 1) unknown_ = keys_.empty() || keys_.contains(name) ? 0 : 1;
        if (!level.keys.insert(name).second) {
            (void)attempt(mistakes_, [&] {
                throw_error(current_location(),
                            "the key " + in_quotes(name) + " is given twice in this object");
            });
        }
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
        check_text_kind(text_, location_.file, expected_);
        std::string message = error.what();
        // "[json.exception.parse_error.101] parse error at line 3, column 7: …"
        if (const auto end = message.find("] "); end != std::string::npos) {
            message.erase(0, end + 2);
        }
        throw_error({location_.file, ""},
                    message + (levels_.empty() ? "" : "; near " + current_location().path));
    }

  private:
    struct Level {
        bool object = false;
        std::size_t index = 0;  ///< Number of entries started, for an array.
        std::string key;
        std::set<std::string> keys;
    };

    /// Count a value before it is stored, because each value of the document needs some 20 bytes.
    bool next() {
        if (levels_.empty()) return true;
        Level& level = levels_.back();
        if (!level.object && level.index >= kMostEntries)
            throw_error(current_location(),
                        "an array of more than " + std::to_string(kMostEntries) + " entries");
        ++values_;
        if (values_ > kMaxValues)
            throw_error(current_location(),
                        "the file has more than " + std::to_string(kMaxValues) + " values");
        if (unknown_ > 0) ++unknown_;
        if (unknown_ > kMaxUnknown)
            throw_error({location_.file, "/" + levels_.front().key},
                        "there is no key " + in_quotes(levels_.front().key) +
                            ", and it holds more than " + std::to_string(kMaxUnknown) +
                            " values; leave it out");
        ++level.index;
        return true;
    }
    bool open(bool object) {
        if (levels_.size() >= kMaxNesting) {
            throw_error(current_location(),
                        "nested more than " + std::to_string(kMaxNesting) + " levels deep");
        }
        levels_.push_back({.object = object, .index = 0, .key = {}, .keys = {}});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return next();
    }
    [[nodiscard]] SourceLocation current_location() const {
        SourceLocation location = location_;
        for (const Level& level : levels_) {
            if (!level.object) {
                location = location / level.index;
            } else if (!level.keys.empty()) {
                location = location / level.key;
            }
        }
        return location;
    }

    SourceLocation location_;
    Mistakes* mistakes_;
    std::string_view text_;
    const char* expected_;
    std::vector<Level> levels_;
    const std::set<std::string>& keys_;
    std::size_t values_ = 0;
    std::size_t unknown_ =
        0;  ///< 0: within a known key; else the number of values below the unknown key plus 1.
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file, const std::set<std::string>& keys,
                Mistakes* mistakes, const char* expected) {
    if (text.size() > kMaxFileBytes) {
        throw_error({file, ""}, "larger than 64 MiB");
    }
    // The parser would stop at a NUL byte and ignore the following text.
    if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
        check_text_kind(text, file, expected);
        throw_error({file, ""}, "a NUL byte at offset " + std::to_string(nul));
    }
    LimitChecker checker(file, keys, mistakes, text, expected);
    Json::sax_parse(text.begin(), text.end(), &checker);
    return Json::parse(text.begin(), text.end());
}

void check_document_kind(const Json& root, const std::string& file, const char* expected) {
    if (root.is_object() || root.is_array()) check_text_kind(root.dump(), file, expected);
}

Json read_json_file(const std::filesystem::path& file, const std::set<std::string>& keys,
                    Mistakes* mistakes, const char* expected) {
    const SourceLocation location{file.string(), ""};
    std::error_code failure;
    // Check before the file is opened: opening a pipe would wait for its writer.
    if (!std::filesystem::is_regular_file(file, failure)) {
        throw_error(location,
                    std::filesystem::exists(file, failure) ? "is no plain file" : "no such file");
    }
    const auto size = std::filesystem::file_size(file, failure);
    if (failure) {
        throw_error(location, "cannot be read: " + failure.message());
    }
    if (size > kMaxFileBytes) {
        throw_error(location, "larger than 64 MiB");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream) {
        throw_error(location, "cannot be read");
    }
    return parse_json(text, location.file, keys, mistakes, expected);
}

std::filesystem::path resolve_inside(const std::filesystem::path& root,
                                     const std::filesystem::path& base, const std::string& name,
                                     const SourceLocation& location) {
    const std::filesystem::path file_name(name);
    if (name.empty() || file_name.is_absolute()) {
        throw_error(location,
                    "expected a file name relative to this file, found " + in_quotes(name));
    }
    std::error_code failure;
    const auto real_root = std::filesystem::weakly_canonical(root.empty() ? "." : root, failure);
    const auto file = std::filesystem::weakly_canonical(
        (base.empty() ? std::filesystem::path(".") : base) / file_name, failure);
    if (failure) {
        throw_error(location,
                    "the file name " + in_quotes(name) + " cannot be used: " + failure.message());
    }
    const auto inside = file.lexically_relative(real_root);
    if (inside.empty() || *inside.begin() == "..") {
        throw_error(location, "the file " + in_quotes(name) +
                                  " lies outside the folder of the scene; " +
                                  "move it into that folder or below");
    }
    if (!std::filesystem::is_regular_file(file, failure)) {
        throw_error(location,
                    "there is no file " + in_quotes(name) + " (looked for " + file.string() + ")");
    }
    return (base / file_name).lexically_normal();
}

std::string describe(const Json& value) {
    switch (value.type()) {
        case Json::value_t::object:
            return "an object";
        case Json::value_t::array:
            return "an array of " + std::to_string(value.size());
        case Json::value_t::string:
            return in_quotes(value.get_ref<const std::string&>());
        default:
            return value.dump();
    }
}

}  // namespace hawser::scene
