// SPDX-License-Identifier: Apache-2.0
#include "exercise/format.h"

#include <hawser/exercise.h>

#include "scene/format.h"

#include <utility>

namespace hawser::exercise {
namespace {

using namespace scene::make;
using scene::Field;
using scene::ShapePtr;

constexpr const char* kFaults[] = {"line_parts",  "motor_loses_force", "brake_slips",
                                   "input_stuck", "input_late",        "output_frozen"};
constexpr const char* kLayouts[] = {"bridge", "winch", "crane", "engine_room"};
constexpr double kMaxTime = 1e6, kMostPoints = 1e6;
constexpr std::size_t kMaxConditions = 16;

ShapePtr list_shape(std::string what, ShapePtr item) {
    return list(std::move(what), std::move(item), 0, kMostEntries);
}
ShapePtr time_shape() { return number("a time", 0.0, kMaxTime); }
ShapePtr points_shape() { return number("points", 0.0, kMostPoints); }

Field text_field() {
    return {"text", text("a text"), false, "", "", "In words, for displays and reports."};
}

/// Return the fields of a trigger: name, text and condition.
std::vector<Field> trigger_fields(const char* which) {
    const ShapePtr condition =
        object("condition", "a condition",
               "Active while the output is at least `above` and at most `below`.",
               {{"output", text("an output"), true, "", "",
                 "Of the scene or of the exercise, or of a system (name.signal)."},
                {"above", number("a number", -1e30, 1e30), false, "-inf", "", "Least value."},
                {"below", number("a number", -1e30, 1e30), false, "inf", "", "Largest value."}});
    return {{"name", name("a name"), true, "", "", which},
            text_field(),
            {"when", list("a list of conditions", condition, 1, kMaxConditions), false, "", "",
             "All of these conditions are met …"},
            {"hold", time_shape(), false, "0", "s", "… for so long without a break; or …"},
            {"event", word("a kind of event", event_words()), false, "", "",
             "… an event of this kind happens …"},
            {"of", text("the beginning of a name"), false, "any", "",
             "… of something with a name that begins so."}};
}

ShapePtr triggered_shape(const char* id, const char* what, const char* doc, std::vector<Field> more,
                         const char* which) {
    std::vector<Field> fields = trigger_fields(which);
    fields.insert(fields.end(), more.begin(), more.end());
    return object(id, what, doc, std::move(fields),
                  {{"when", "event"}, {"hold", "event"}, {"when", "of"}});
}

ShapePtr station_shape() {
    return object(
        "station", "a station", "A role that operates some inputs.",
        {{"name", name("a name"), true, "", "", "Of the role; not instructor or watcher."},
         text_field(),
         {"layout", word("a layout", {std::begin(kLayouts), std::end(kLayouts)}), false,
          "by its inputs", "", "Instruments and forms of controls in the page."},
         {"inputs", list_shape("a list of inputs", text("an input")), true, "", "",
          "That it may set: inputs, and signals of systems (winch.speed)."}});
}

ShapePtr fault() {
    const Field common[] = {
        {"name", name("a name"), true, "", "", "Unique among faults."},
        text_field(),
        {"kind", word("a kind of fault", {std::begin(kFaults), std::end(kFaults)}), true, "", "",
         "Kind."},
        {"at", time_shape(), false, "when the instructor starts it", "s",
         "Time at which it starts."}};
    const Field lasts{"lasts", time_shape(), false, "to the end", "s", "Ends by itself."};
    const Field share{"share", number("a share", 0.0, 1.0), false, "0",
                      "1",     "Fraction that remains."};
    const auto of = [&](const char* id, const char* doc, std::vector<Field> own) {
        std::vector<Field> fields{std::begin(common), std::end(common)};
        fields.insert(fields.end(), own.begin(), own.end());
        return object(id, "a fault", doc, std::move(fields));
    };
    auto out = std::make_shared<scene::Shape>();
    out->type = scene::Shape::Type::switched;
    out->id = "fault";
    out->what = "a fault";
    out->doc = "A fault that starts at a time or by the instructor.";
    out->key = "kind";
    const auto target = [](const char* key, const char* doc) {
        return Field{key, text("a name"), true, "", "", doc};
    };
    out->cases = {
        {kFaults[0], of("fault_line", "A line breaks permanently.",
                        {target("wire", "Wire, or one of its elements."),
                         {"s", number("a length", 0.0, 1e6), false, "its middle", "m",
                          "From the wire's first end, unstretched."}})},
        {kFaults[1],
         of("fault_motor",
            "A motor loses force. Of a winch all of it: its modes speed, tension and render act as "
            "free.",
            {target("motor", "Winch, or interaction of a kind that drives."), share, lasts})},
        {kFaults[2],
         of("fault_brake", "A brake has less holding force.",
            {target("brake", "Winch, or interaction of a kind that rubs."), share, lasts})},
        {kFaults[3], of("fault_stuck", "An input is stuck.",
                        {target("input", "Input."),
                         {"value", number("a number", -1e30, 1e30), false, "its value at that time",
                          "", "Value to which it moves instead."},
                         lasts})},
        {kFaults[4], of("fault_late", "An input acts with a delay.",
                        {target("input", "Input."),
                         {"delay", positive("a time", 600.0), true, "", "s", "So late."},
                         lasts})},
        {kFaults[5], of("fault_frozen", "Displays and alarms keep the value that an output had.",
                        {target("output", "Output."), lasts})}};
    return out;
}

std::vector<Field> list_fields() {
    const Field points{"points", points_shape(), false, "0", "", "Points for it."};
    const ShapePtr goal = triggered_shape(
        "goal", "a goal", "Text of the goal.",
        {{"points", points_shape(), true, "", "", "Points for it."},
         {"after", text("a goal"), false, "", "", "Counts only once that goal is reached."},
         {"by", time_shape(), false, "the end", "s", "Time after which it gives no points."}},
        "Unique among goals.");
    const ShapePtr phase =
        object("phase", "a phase", "A part of the task, for displays and reports.",
               {{"name", name("a name"), true, "", "", "Unique among phases."},
                text_field(),
                {"goal", text("a goal"), false, "no end condition", "", "Goal that ends it."}});
    const ShapePtr penalty =
        triggered_shape("penalty", "a penalty", "Conditions that cost points.",
                        {{"points", points_shape(), false, "0", "", "Each time it begins."},
                         {"per_second", points_shape(), false, "0", "", "And while it lasts."},
                         {"most", points_shape(), false, "no limit", "", "In all."}},
                        "Unique among penalties.");
    const ShapePtr end = triggered_shape("end", "an end", "Conditions that end the exercise.",
                                         {{"failed", boolean("true or false"), false, "false", "",
                                           "Whether it has then failed, whatever the points."}},
                                         "Unique among ends.");
    return {
        {"stations", list_shape("a list of stations", station_shape()), false, "none", "",
         "Roles."},
        {"displays", list_shape("a list of outputs", text("an output")), false, "none", "",
         "Outputs that stations display and reports draw."},
        {"faults", list_shape("a list of faults", fault()), false, "none", "", "Faults."},
        {"alarms",
         list_shape("a list of alarms",
                    triggered_shape("alarm", "an alarm", "Active while the condition is met.", {},
                                    "Unique among alarms.")),
         false, "none", "", "Alarms."},
        {"goals", list_shape("a list of goals", goal), false, "none", "", "Goals."},
        {"phases", list_shape("a list of phases", phase), false, "none", "",
         "Phases in their order."},
        {"penalties", list_shape("a list of penalties", penalty), false, "none", "", "Penalties."},
        {"ends", list_shape("a list of ends", end), false, "none", "",
         "Further conditions, besides the time and all goals reached."}};
}

ShapePtr make_shape() {
    std::vector<Field> fields{
        {"$schema", text("a text"), false, "", "", "For editors."},
        {"version", integer("the version 1", 1, 1), true, "", "", "Version of the format: 1."},
        {"exercise", name("a name"), true, "", "", "Name of the exercise."},
        {"description", text("a text"), false, "", "", "Description of the exercise."},
        {"scene", text("a file name"), true, "", "",
         "Scene, relative to this file and not above the folder that its folder is in."},
        {"set", list("a list of changes", text("path=value"), 0, 64), false, "none", "",
         "Changes to the scene, as --set."},
        {"duration", number("a time", 1e-3, kMaxTime), true, "", "s", "It ends then."},
        {"until_done", boolean("true or false"), false, "true", "",
         "It also ends once all goals have been reached, or are too late."},
        {"pass", points_shape(), false, "0", "", "Points that are needed."},
        {"inputs", list_of("a list of inputs", scene::input_shape()), false, "none", "",
         "Added to the scene's."},
        {"outputs", list_of("a list of outputs", scene::output_shape()), false, "none", "",
         "Added to the scene's."},
        {"timeline", list_of("a list of operations", scene::operation_shape()), false,
         "the scene's", "", "Value instead of the scene's."}};
    for (Field& field : list_fields()) fields.push_back(std::move(field));
    return object("exercise", "an exercise", "An exercise file.", std::move(fields));
}

}  // namespace

std::span<const char* const> fault_words() noexcept { return kFaults; }

std::span<const char* const> station_layouts() noexcept { return kLayouts; }

std::vector<std::string> event_words() {
    std::vector<std::string> out;
    for (int k = 0; k < kEventKindCount; ++k)
        out.emplace_back(hawser::to_string(static_cast<EventKind>(k)));
    return out;
}

const scene::ShapePtr& exercise_shape() {
    static const ShapePtr kShape = make_shape();
    return kShape;
}

const char* to_string(FaultKind kind) noexcept { return kFaults[static_cast<std::size_t>(kind)]; }

}  // namespace hawser::exercise
