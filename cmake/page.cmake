# Writes a C++ source with the page of a plan in it, put together from framework/graph/page/.
# Called at build time with FOLDER, SCRIPTS (in order) and OUTPUT.
file(READ ${FOLDER}/page.html page)
file(READ ${FOLDER}/page.css style)
set(script "")
foreach(name IN LISTS SCRIPTS)
    file(READ ${FOLDER}/${name} part)
    string(APPEND script "${part}")
endforeach()
string(REPLACE "{{style}}" "${style}" page "${page}")
string(REPLACE "{{script}}" "${script}" page "${page}")
file(WRITE ${OUTPUT} "// Made by cmake/page.cmake.
#include \"graph/page_template.h\"
namespace nephrite::graph {
std::string_view pageTemplate() { return R\"page(${page})page\"; }
}  // namespace nephrite::graph
")
