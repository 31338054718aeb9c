#include <cstdio>
#include <cstdlib>

#include "cli/run.hpp"
#include "cli/terminal/interrupt.hpp"

int main(int argc, char** argv) {
    cardioid::cli::make_write_errors_visible();
    const int status = cardioid::cli::run({argv + 1, argv + argc});
    if (status == 0) return 0;
    // Who is told of an error need not wait for libraries that are still being loaded for a picture.
    std::fflush(nullptr);
    std::_Exit(status);
}
