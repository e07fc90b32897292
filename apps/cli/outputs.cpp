// SPDX-License-Identifier: Apache-2.0
#include "outputs.h"

#include "record/files.h"

#include <fmt/format.h>

#include <stdexcept>

namespace hawser::cli {

void check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
    for (auto out = outputs.begin(); out != outputs.end(); ++out) {
        if (out->file.empty()) continue;
        for (const NamedFile& in : inputs)
            if (!in.file.empty() && record::same_file(in.file, out->file))
                throw std::runtime_error(
                    fmt::format("{}: {} would overwrite {}, which is read; give another name",
                                out->file, out->what, in.what));
        for (auto other = outputs.begin(); other != out; ++other)
            if (!other->file.empty() && record::same_file(other->file, out->file))
                throw std::runtime_error(
                    fmt::format("{}: {} and {} are the same file; give two names", out->file,
                                other->what, out->what));
        if (const std::string fault = record::output_fault(out->file); !fault.empty())
            throw std::runtime_error(
                fmt::format("{}: cannot write {}: {}", out->file, out->what, fault));
    }
}

void write_output(const std::string& file, const std::string& text, const char* what) {
    if (const std::string fault = record::write_file(file, text); !fault.empty())
        throw std::runtime_error(fmt::format("{}: cannot write {}: {}", file, what, fault));
}

}  // namespace hawser::cli
