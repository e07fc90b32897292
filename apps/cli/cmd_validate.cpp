// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "validate/validate.h"

#include <memory>

namespace hawser::cli {

namespace {

constexpr const char* kValidateFooter = R"(Examples:
  hawser validate
  hawser validate --list
  hawser validate robust
  hawser validate wires
  hawser validate sea
  hawser validate firstday
  hawser validate untuned
  hawser validate vessels
  hawser validate rao --data FOLDER
  hawser validate pendulum catenary --json validation.json

Runs cases with a known solution. Prints case, quantity, reference, result, error and observed
order.

Exit codes: 0 all within tolerance, 1 unknown case, 3 at least one outside.)";

struct ValidateOptions {
    std::vector<std::string> cases;
    std::string json, data;
    bool list = false;
};

}  // namespace

void add_validate(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ValidateOptions>();
    CLI::App* command =
        app.add_subcommand("validate", "Compare with analytic and published solutions");
    command->footer(kValidateFooter);
    command->add_option("CASE", options->cases,
                        "Names of cases. Without a name: all except the sets `robust`, `wires`, "
                        "`sea`, `firstday`, `untuned` and `vessels`");
    command->add_option("--json", options->json, "Write the results as JSON");
    command
        ->add_option("--data", options->data,
                     "Folder with data of others: `rao` needs it, `sea_sphere` takes more of it")
        ->check(CLI::ExistingDirectory);
    command->add_flag("--list", options->list, "Print the names of the cases");
    command->callback([&chosen, options] {
        chosen = [options] {
            return validate::run_cases(options->cases, options->json, options->list, options->data);
        };
    });
}

}  // namespace hawser::cli
