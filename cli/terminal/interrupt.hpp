#pragma once

namespace cardioid::cli {

/// Writing past a file size limit or into a closed pipe becomes an error of the write instead of a signal.
void make_write_errors_visible();

/// From here on the first SIGINT or SIGTERM only sets interrupted(), so that what there is can be saved; the second
/// ends the program.
void catch_interrupts();

/// Whether the user wants to stop. Any thread may call it.
bool interrupted() noexcept;

}  // namespace cardioid::cli
