# Sets openimageio_libraries, lines of C++: the libraries that OpenImageIO needs, each after those that it needs itself.
# Loaded in that order each looks for its symbols in its own libraries; loaded at once, all look in all 250 of them, which
# takes nearly twice the time. The loader itself tells the order when asked what it does. Without it (another C library)
# the list is empty and all are loaded at once.
get_target_property(file OpenImageIO::OpenImageIO LOCATION)
execute_process(
  COMMAND env LD_DEBUG=files LD_PRELOAD=${file} true
  OUTPUT_QUIET ERROR_VARIABLE told)
string(REGEX MATCHALL "calling init: [^\n]*" steps "${told}")
set(openimageio_libraries "")
foreach(step IN LISTS steps)
  get_filename_component(name "${step}" NAME)
  if(name MATCHES "^lib.*[.]so" AND NOT step STREQUAL "calling init: ${file}")
    string(APPEND openimageio_libraries "    \"${name}\",\n")
  endif()
endforeach()
