#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "rt_core/api/error.hpp"

namespace cardioid::test {

namespace {

constexpr unsigned most_seconds = 20;
constexpr long most_kilobytes = 1 << 20;

/// The highest memory of this process so far, in kilobytes.
long peak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

const std::string* current = nullptr;

/// Leaves the text that a reader failed on.
void keep_current(int number) {
    const int file = ::open("damaged", O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (current && file >= 0 && ::write(file, current->data(), current->size()) < 0) ::_exit(number);
    std::signal(number, SIG_DFL);
    std::raise(number);
}

/// Of CPU time from now on, until SIGPROF; 0: no limit.
void limit_seconds(unsigned seconds) {
    const itimerval limit{{}, {static_cast<time_t>(seconds), 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
}

class Damage {
public:
    Damage(std::string& text, std::mt19937& random) : text_(text), random_(random) {}

    void once() {
        const std::size_t at = below(text_.size());
        switch (below(8)) {
            case 0:
                text_[at] = static_cast<char>(below(256));
                break;
            case 1:
                text_[at] = static_cast<char>(text_[at] ^ (1 << below(8)));
                break;
            case 2:
                text_.erase(at, 1 + below(16));
                break;
            case 3:
                text_.insert(at, word());
                break;
            case 4:
                text_.insert(at, text_.substr(below(text_.size()), below(64)));
                break;
            case 5:
                exchange_word(at);
                break;
            case 6:
                write_number(at);
                break;
            default:
                if (below(8) == 0) text_.resize(at);
                if (!text_.empty()) text_[below(text_.size())] = "\xFF\x7F\x80\x00"[below(4)];
        }
    }

private:
    std::size_t below(std::size_t n) {
        return n == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }
    const std::string& word() {
        static const std::string words[] = {"{",    "}",    "\"",     "-1",    "1e308",      "nan",
                                            "\n",   ";",    "{l a}",  "#",     "4294967295", "9999999999999",
                                            "0",    "-0.0", "1e-320", "65536", "2147483648", std::string(1, '\0'),
                                            "1e19", "inf",  "[",      "]",     "1000000",    "-1e30"};
        return words[below(std::size(words))];
    }
    /// A word, or a number, in place of the one around `at`.
    void exchange_word(std::size_t at) {
        const auto inside = [&](std::size_t i) {
            return std::isalnum(static_cast<unsigned char>(text_[i])) || text_[i] == '.' || text_[i] == '-';
        };
        std::size_t from = at, to = at;
        while (from > 0 && inside(from - 1)) --from;
        while (to < text_.size() && inside(to)) ++to;
        text_.replace(from, to - from, word());
    }
    /// Whole numbers and reals of binary files, in either order.
    void write_number(std::size_t at) {
        static constexpr std::uint64_t numbers[] = {0,
                                                    1,
                                                    0x7F,
                                                    0x80,
                                                    0xFFFF,
                                                    0x7FFFFFFF,
                                                    0x80000000,
                                                    0xFFFFFFFF,
                                                    1ULL << 63,
                                                    ~0ULL,
                                                    0x7FF0000000000000,
                                                    0x7FF8000000000000,
                                                    0x7FEFFFFFFFFFFFFF,
                                                    0x10000};
        std::uint64_t value = numbers[below(std::size(numbers))];
        std::string bytes(std::size_t{1} << below(4), '\0');
        for (char& c : bytes) c = static_cast<char>(value & 0xFF), value >>= 8;
        if (below(2) == 0) std::ranges::reverse(bytes);
        text_.replace(at, bytes.size(), bytes);
    }

    std::string& text_;
    std::mt19937& random_;
};

}  // namespace

std::string mutated(std::string text, std::mt19937& random) {
    Damage damage(text, random);
    for (std::size_t i = 1 + random() % 4; i > 0 && !text.empty(); --i) damage.once();
    return text;
}

std::size_t mutations() {
    const char* given = std::getenv("CARDIOID_MUTATIONS");
    return given ? static_cast<std::size_t>(std::strtoull(given, nullptr, 10)) : 1000;
}

void survive(const std::string& sample, unsigned seed, const std::function<void(const std::string&)>& read) {
    for (const int number : {SIGABRT, SIGPROF, SIGSEGV, SIGFPE}) std::signal(number, keep_current);
    std::mt19937 random(seed);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < mutations(); ++i) {
        const std::string text = mutated(sample, random);
        const long before = peak();
        current = &text;
        limit_seconds(most_seconds);
        try {
            read(text);
        } catch (const Error& error) {
            ++refused;
            ASSERT_FALSE(std::string(error.what()).empty());
        }
        if (peak() - before > most_kilobytes) std::abort();
    }
    limit_seconds(0);
    current = nullptr;
    EXPECT_GT(refused, 0U);  // else nothing was damaged
}

}  // namespace cardioid::test
