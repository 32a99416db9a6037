// A graph of one pass that reads its arguments from imported images, a texel a row.
#include "reference/shader_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "image/exr.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::reference {
namespace {

constexpr std::size_t width = 256;

/// The rows as an image, the last one repeated to its end.
image::Image imageOf(const Column& column) {
    image::Image image;
    image.width = width;
    image.height = static_cast<std::uint32_t>((column.rows.size() + width - 1) / width);
    image.channels = {"R", "G", "B", "A"};
    for (std::size_t i = 0; i < width * image.height; ++i) {
        const glm::vec4& row = column.rows[std::min(i, column.rows.size() - 1)];
        image.pixels.insert(image.pixels.end(), {row.x, row.y, row.z, row.w});
    }
    return image;
}

void writePass(const ScratchFolder& folder, const std::string& glsl, const std::vector<Column>& columns) {
    std::string inputs;
    for (const Column& column : columns)
        inputs += fmt::format("{}\"{}\": {{}}", inputs.empty() ? "" : ", ", column.name);
    folder.write("passes/row.json",
                 fmt::format(R"json({{"kind": "pixel", "shader": "row.glsl", "inputs": {{{}}},
                     "outputs": {{"result": {{"format": "rgba32f", "size": {{"like": "{}"}}}}}}}})json",
                             inputs, columns.front().name));
    folder.write("passes/row.glsl", glsl + "\nvoid pixel(ivec2 p) { store(result, p, row(p)); }\n");
}

std::filesystem::path writeGraph(const ScratchFolder& folder, const std::vector<Column>& columns) {
    std::string imports, inputs;
    for (const Column& column : columns) {
        const char* comma = imports.empty() ? "" : ", ";
        imports += fmt::format("{}\"{}\": {{\"image\": \"{}.exr\"}}", comma, column.name, column.name);
        inputs += fmt::format("{}\"{}\": \"import({})\"", comma, column.name, column.name);
        image::writeExr(folder.path() / (column.name + ".exr"), imageOf(column));
    }
    return folder.write("rows.json", fmt::format(R"json({{"name": "rows", "imports": {{{}}},
        "nodes": {{"row": {{"pass": "row", "in": {{{}}}}}}}, "outputs": {{"color": "row.result"}}}})json",
                                                 imports, inputs));
}

}  // namespace

std::vector<glm::vec4> evaluateRows(const std::string& glsl, const std::vector<Column>& columns) {
    const std::size_t rows = columns.front().rows.size();
    for (const Column& column : columns)
        if (column.rows.size() != rows || rows == 0)
            throw std::invalid_argument(column.name + " has " + std::to_string(column.rows.size()) + " rows");
    const ScratchFolder folder;
    writePass(folder, glsl, columns);
    runtime::SessionOptions options;
    options.graph = writeGraph(folder, columns);
    options.passPaths = {folder.path() / "passes"};
    options.scene = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs/scenes/empty.json";
    runtime::Session session(options);
    session.renderFrame(0);
    const image::Image image = session.read("color");
    std::vector<glm::vec4> results;
    for (std::size_t i = 0; i < rows; ++i) {
        const float* value = &image.pixels[i * 4];
        results.emplace_back(value[0], value[1], value[2], value[3]);
    }
    return results;
}

}  // namespace nephrite::reference
