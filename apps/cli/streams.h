// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file streams.h
/// Standard output and error that may be closed, full or gone.
///
/// A file opened by a program whose standard output is closed gets its number, and what is printed
/// ends up in it; and a print that fails throws. From open_streams() on the three numbers are
/// taken, and prints succeed: what could not be written is remembered until the end.

namespace hawser::cli {

/// First of all in main(). SIGPIPE is ignored: a run goes on where nobody reads its report. So is
/// SIGXFSZ: a file that may not grow further (ulimit -f) fails like one on a full disk, with a
/// message.
void open_streams() noexcept;

/// Last of all. @param code  What the program would return. @return that, or kUsageError where it
/// is success and standard output has not taken all that was printed.
[[nodiscard]] int close_streams(int code) noexcept;

}  // namespace hawser::cli
