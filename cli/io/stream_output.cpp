#include "cli/io/stream_output.hpp"

#include "cli/io/text_output.hpp"

namespace cardioid::cli {

void StreamOutput::write(std::string_view text) {
    if (file_)
        file_->write(std::as_bytes(std::span(text)));
    else
        print_text(std::string(text));
}

}  // namespace cardioid::cli
