// SPDX-License-Identifier: Apache-2.0
#include "golden/figure_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace hawser::golden {

namespace {

using nlohmann::json;

/// Tolerances relative to the scale: smallest, largest of a scene, largest of a single figure.
constexpr double kMinimum = 1e-9, kMaximum = 1e-6, kLoose = 1e-4;

Entry parse(const json& in) {
    Entry entry;
    entry.steps = in.at("steps").get<int>();
    entry.tolerance = in.at("tolerance").get<double>();
    for (const auto& [name, text] : in.at("texts").items())
        entry.texts[name] = text.get<std::string>();
    for (const auto& [name, count] : in.at("counts").items())
        entry.counts[name] =
            count.is_null() ? std::nullopt : std::optional(count.get<std::int64_t>());
    for (const auto& [name, real] : in.at("reals").items())
        entry.reals[name] = {real.at(0).get<double>(), real.at(1).get<double>(),
                             real.size() > 2 ? real.at(2).get<double>() : 0.0};
    return entry;
}

/// Write a map as a JSON object, one line for each member.
template <class Map, class Format>
std::string object(const Map& map, Format format) {
    std::string out;
    for (const auto& [name, value] : map)
        out +=
            fmt::format("{}    {}: {}", out.empty() ? "" : ",\n", json(name).dump(), format(value));
    return "{\n" + out + "}";
}

std::string dump(const Entry& entry) {
    return fmt::format(
        "{{\"steps\": {}, \"tolerance\": {:.2g},\n  \"texts\": {},\n  \"counts\": {},\n"
        "  \"reals\": {}}}",
        entry.steps, entry.tolerance,
        object(entry.texts, [](const std::string& text) { return json(text).dump(); }),
        object(entry.counts,
               [](std::optional<std::int64_t> count) {
                   return count ? std::to_string(*count) : std::string("null");
               }),
        object(entry.reals, [](const Real& real) {
            const std::string own =
                real.tolerance > 0.0 ? fmt::format(", {:.2g}", real.tolerance) : "";
            return fmt::format("[{:.13g}, {:.3g}{}]", real.value, real.scale, own);
        }));
}

/// Return a difference in units of the scale.
double error_of(const Real& reference, const Real& figure) {
    const double scale = reference.scale > 0.0 ? reference.scale : figure.scale;
    return std::abs(figure.value - reference.value) / scale;
}

std::string compare_texts(const Entry& reference, const Figures& figures) {
    std::string out;
    for (const auto& [name, text] : figures.texts)
        if (const auto found = reference.texts.find(name);
            found == reference.texts.end() || found->second != text)
            out += fmt::format("  {}: \"{}\" instead of \"{}\"\n", name, text,
                               found == reference.texts.end() ? "" : found->second);
    return out;
}

std::string compare_counts(const Entry& reference, const Figures& figures) {
    std::string out;
    for (const auto& [name, count] : figures.counts) {
        const auto found = reference.counts.find(name);
        const auto expected = found != reference.counts.end() ? found->second : std::int64_t{0};
        if (expected && *expected != count)
            out += fmt::format("  {}: {} instead of {}\n", name, count, *expected);
    }
    return out;
}

std::string compare_reals(const Entry& reference, const Figures& figures) {
    std::string out;
    for (const auto& [name, real] : figures.reals) {
        const auto found = reference.reals.find(name);
        const Real expected = found != reference.reals.end() ? found->second : Real{};
        const double error = error_of(expected, real);
        const double allowed = std::max(reference.tolerance, expected.tolerance);
        if (!(error <= allowed))
            out += fmt::format(
                "  {}: {:.13g} instead of {:.13g}: {:.2g} of its scale, {:.2g} is allowed\n", name,
                real.value, expected.value, error, allowed);
    }
    return out;
}

/// Return a line for each name in the file that no longer is a figure.
template <class A, class B>
std::string left_over(const A& reference, const B& figures) {
    std::string out;
    for (const auto& [name, value] : reference)
        if (!figures.contains(name)) out += fmt::format("  {}: only in the file\n", name);
    return out;
}

}  // namespace

Entries read_entries(const std::filesystem::path& file) {
    Entries entries;
    std::ifstream in(file);
    if (!in) return entries;
    const json document = json::parse(in);
    for (const auto& [name, entry] : document.items()) entries[name] = parse(entry);
    return entries;
}

void write_entries(const std::filesystem::path& file, const Entries& entries) {
    std::string out;
    for (const auto& [name, entry] : entries)
        out += fmt::format("{}{}: {}", out.empty() ? "" : ",\n", json(name).dump(), dump(entry));
    std::ofstream(file) << "{\n" << out << "\n}\n";
}

std::string compare(const Entry& reference, const Figures& figures) {
    return left_over(reference.texts, figures.texts) + left_over(reference.counts, figures.counts) +
           left_over(reference.reals, figures.reals) + compare_texts(reference, figures) +
           compare_counts(reference, figures) + compare_reals(reference, figures);
}

Entry entry_of(const Figures& figures, int steps) {
    Entry entry;
    entry.steps = steps;
    entry.tolerance = kMinimum;
    entry.texts = figures.texts;
    for (const auto& [name, count] : figures.counts)
        if (count != 0) entry.counts[name] = count;
    for (const auto& [name, real] : figures.reals)
        if (real.value != 0.0) entry.reals[name] = real;
    return entry;
}

std::pair<std::string, double> widen(Entry& entry, const Figures& figures) {
    constexpr double kMargin = 1000.0;
    std::pair<std::string, double> most;
    for (const auto& [name, real] : figures.reals) {
        const auto found = entry.reals.find(name);
        const double error = error_of(found != entry.reals.end() ? found->second : Real{}, real);
        if (error > most.second) most = {name, error};
        if (kMargin * error <= kMaximum) {
            entry.tolerance = std::max(entry.tolerance, kMargin * error);
        } else {
            Real& own = entry.reals.try_emplace(name, Real{0.0, real.scale, 0.0}).first->second;
            own.tolerance = std::max(own.tolerance, std::min(kMargin * error, kLoose));
        }
    }
    for (const auto& [name, count] : figures.counts) {
        const auto found = entry.counts.find(name);
        const auto expected = found != entry.counts.end() ? found->second : std::int64_t{0};
        if (expected && *expected != count) entry.counts[name].reset();
    }
    return most;
}

}  // namespace hawser::golden
