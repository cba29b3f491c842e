// Output that never leaves half a file behind, and never loses the file that was there before.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace minksum::cli {

/// Throws a Failure with the system's reason if `path` can hardly be written; cheap and early, so
/// that nobody waits for a result that then has no place to go.
void check_writable(const std::string& path);

/// Lets `write` fill the file `path`, or standard output for an empty path or "-".
///
/// A file is written beside its place under another name, and moved there when it is complete;
/// devices and pipes are written as they are. Throws a Failure with the system's reason.
void write_output(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Makes the folder if it is not there. Throws a Failure.
void make_folder(const std::string& path);

}  // namespace minksum::cli
