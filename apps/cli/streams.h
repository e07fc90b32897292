// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file streams.h
/// Standard output and error that may be closed, full or gone.
///
/// If standard output is closed, the next file that a program opens gets its number, and printed
/// text ends up in that file. A failed print throws. After open_streams() the three numbers are in
/// use, and prints succeed: a write failure is recorded until the end.

namespace hawser::cli {

/// Prepare the streams. Call first in main(). SIGPIPE is ignored, so that a run continues if its
/// report has no reader. SIGXFSZ is ignored, so that a write beyond the size limit (ulimit -f)
/// fails with a message, as on a full disk.
void open_streams() noexcept;

/// Finish the streams. Call last. @param code  Exit code of the program. @return the code, or
/// kUsageError if it is success and standard output failed.
[[nodiscard]] int close_streams(int code) noexcept;

}  // namespace hawser::cli
