// The exchange of semaphores and images around each picture in a window.
#include "gpu/frame_presenter.h"

namespace nephrite::gpu {
namespace {

constexpr std::size_t slotCount = 2;

VkSemaphoreSubmitInfo submitInfo(VkSemaphore semaphore) {
    VkSemaphoreSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    info.semaphore = semaphore;
    info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    return info;
}

}  // namespace

FramePresenter::FramePresenter(const Device& device, VkSurfaceKHR surface, PresentMode mode)
    : device_(device), surface_(surface), mode_(mode) {
    makeSlots();
}

FramePresenter::~FramePresenter() {
    // What was handed to the window system holds semaphores that no fence covers.
    vkDeviceWaitIdle(device_.handle());
}

FramePresenter::Semaphore FramePresenter::makeSemaphore() const {
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    device_.check(vkCreateSemaphore(device_.handle(), &info, nullptr, &semaphore),
                  "cannot create a semaphore");
    return {device_.handle(), semaphore};
}

void FramePresenter::makeSlots() {
    slots_.clear();
    for (std::size_t i = 0; i < slotCount; ++i) slots_.emplace_back(device_).available = makeSemaphore();
}

bool FramePresenter::prepare(VkExtent2D window) {
    const VkExtent2D extent = Swapchain::extentOf(device_, surface_, window);
    if (extent.width == 0 || extent.height == 0) return false;
    const bool fits = swapchain_ && !outdated_ && swapchain_->extent().width == extent.width &&
                      swapchain_->extent().height == extent.height;
    if (fits) return true;
    device_.waitIdle();
    auto next = std::make_unique<Swapchain>(device_, surface_, window, mode_, swapchain_.get());
    swapchain_ = std::move(next);
    drawn_.clear();
    for (std::size_t i = 0; i < swapchain_->images().size(); ++i) drawn_.push_back(makeSemaphore());
    outdated_ = false;
    ++generation_;
    return true;
}

bool FramePresenter::show(const Draw& draw) {
    Slot& slot = slots_[next_];
    slot.commands.wait();  // its semaphore is free again, too
    const auto image = swapchain_->acquire(slot.available.get());
    if (!image) {
        outdated_ = true;
        return false;
    }
    const VkSemaphore drawn = drawn_[image->index].get();
    try {
        slot.commands.begin();
        draw(slot.commands.handle(), *image);
        slot.commands.end();
        slot.commands.submit(submitInfo(slot.available.get()), submitInfo(drawn));
    } catch (...) {
        discard();
        throw;
    }
    next_ = (next_ + 1) % slots_.size();
    if (!swapchain_->present(*image, drawn)) outdated_ = true;
    return true;
}

/// An image was taken and cannot be given back, and its semaphore will be signalled: all of it is made anew.
void FramePresenter::discard() {
    vkDeviceWaitIdle(device_.handle());
    swapchain_.reset();
    makeSlots();
    next_ = 0;
}

void FramePresenter::waitForAll() {
    for (Slot& slot : slots_) slot.commands.wait();
}

}  // namespace nephrite::gpu
