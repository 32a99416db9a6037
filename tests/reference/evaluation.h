// Each shader's output beside the double-precision value of its formula, the formula fed with the shader's
// own inputs as they were dumped.
#pragma once

#include <string>
#include <vector>

#include "reference/agreement.h"
#include "reference/dumped_frame.h"
#include "reference/literal/direct.h"
#include "reference/scene_data.h"

namespace nephrite::reference {

/// One image (or some channels of it) compared.
struct Comparison {
    std::string what;  ///< "dipole.radiance"
    Agreement agreement;
    double tolerance = 1e-3;  ///< relative; 2e-3 for half floats, which the driver truncates
};

class Evaluation {
  public:
    Evaluation(const DumpedFrame& frame, const SceneData& scene);

    /// Texels of the lights' G-buffers lie on the rays through their centres.
    Comparison lightViews() const;
    std::vector<Comparison> layers() const;
    Comparison lightIrradiance() const;
    Comparison direct() const;
    Comparison singleScatter() const;
    Comparison dipole() const;
    Comparison ambientOcclusion() const;
    Comparison specular() const;
    Comparison refraction() const;
    Comparison composite() const;

    bool covered(glm::ivec2 pixel) const { return position_.at(pixel.x, pixel.y).w != 0; }

  private:
    void attachLightImages();
    std::vector<glm::ivec2> coveredPixels() const;
    std::size_t materialAt(glm::ivec2 pixel) const;
    SurfacePoint pointAt(glm::ivec2 pixel) const;
    LayerStack layersAt(glm::ivec2 pixel) const;
    Comparison comparisonOf(const std::string& port) const;
    std::vector<Comparison> layerImages(const std::string& node, const std::vector<Texels>& surfaces) const;

    /// Compares "node.port" with `expected(pixel)` at every covered pixel.
    template<class Expected>
    Comparison compare(const std::string& port, Expected expected) const;

    const DumpedFrame& frame_;
    const SceneData& scene_;
    std::vector<PointLight> lights_;
    Texels position_;
    Texels normal_;
    Texels surface_;
    std::vector<Texels> thickness_;
    std::vector<Texels> absorption_;
    std::vector<Texels> scattering_;
};

}  // namespace nephrite::reference
