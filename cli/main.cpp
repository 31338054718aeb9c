#include "cli/run.hpp"
#include "cli/terminal/interrupt.hpp"

int main(int argc, char** argv) {
    cardioid::cli::make_write_errors_visible();
    return cardioid::cli::run({argv + 1, argv + argc});
}
