#include "formats/mesh/byte_cursor.hpp"

#include "rt_core/api/error.hpp"

namespace cardioid::formats {

void ByteCursor::fail(std::string_view found, std::string_view wanted) const {
    throw Error(ErrorCode::bad_input, file_ + ":byte " + std::to_string(at_) + ": found " + std::string(found) +
                                          ", wanted " + std::string(wanted));
}

}  // namespace cardioid::formats
