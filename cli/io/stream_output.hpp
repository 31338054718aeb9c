#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "rt_core/image/atomic_file.hpp"

namespace cardioid::cli {

/// Text that is written as it comes: a file appears whole at the end, standard output ("-") gets each piece at once.
class StreamOutput {
public:
    /// Throws Error(io).
    explicit StreamOutput(const std::string& path) {
        if (path != "-") file_.emplace(path);
    }
    void write(std::string_view text);
    /// Nothing can be written after it; without it there is no file.
    void finish() {
        if (file_) file_->commit();
    }

private:
    std::optional<AtomicFile> file_;
};

}  // namespace cardioid::cli
