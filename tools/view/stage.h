// What the window shows in one picture: images of a session under the controls.
#pragma once

#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/frame_presenter.h"
#include "gpu/image.h"
#include "image/png.h"
#include "view/picture_placement.h"
#include "view/user_interface.h"

namespace nephrite::view {

/// An image in TRANSFER_SRC_OPTIMAL, and which part of it goes where.
struct ShownImage {
    const gpu::Image* image = nullptr;
    Blit blit;
};

class Stage {
  public:
    /// All must outlive it.
    Stage(const gpu::Device& device, gpu::FramePresenter& presenter, UserInterface& controls)
        : device_(device), presenter_(presenter), controls_(controls) {}

    /// Draws the images and the controls over them, and shows both. False as FramePresenter::show.
    bool show(const std::vector<ShownImage>& images);
    /// The same, and what the window then shows, opaque. Nothing if it could not be shown.
    std::optional<image::ByteImage> showAndCapture(const std::vector<ShownImage>& images);

  private:
    void draw(VkCommandBuffer commands, const gpu::SwapchainImage& target,
              const std::vector<ShownImage>& images);
    void blit(VkCommandBuffer commands, VkImage target, const ShownImage& shown);
    void copyOut(VkCommandBuffer commands, VkImage source, const gpu::Buffer& buffer) const;

    const gpu::Device& device_;
    gpu::FramePresenter& presenter_;
    UserInterface& controls_;
};

}  // namespace nephrite::view
