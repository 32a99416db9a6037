// Starting Dear ImGui with its GLFW and Vulkan parts.
#include "view/user_interface.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <filesystem>

#include "gpu/commands.h"
#include "gpu/result.h"
#include "view/style.h"

namespace nephrite::view {
namespace {

/// The library calls it from C++ code of its own, which exceptions pass through.
void checkResult(VkResult result) {
    gpu::check(result, "cannot draw the controls");
}

VkAttachmentDescription windowAttachment(VkFormat format) {
    VkAttachmentDescription attachment{};
    attachment.format = format;
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    attachment.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    attachment.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    return attachment;
}

}  // namespace

UserInterface::Context::Context() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
}

UserInterface::Context::~Context() {
    ImGui::DestroyContext();
}

UserInterface::UserInterface(const Window& window, const gpu::Device& device,
                             const gpu::FramePresenter& presenter)
    : device_(device), presenter_(presenter) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // no file of its own beside the user's
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    applyStyle(window.contentScale());
    makeRenderPass();
    makeDescriptorPool();
    start(window);
}

UserInterface::~UserInterface() {
    vkDeviceWaitIdle(device_.handle());
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
}

void UserInterface::makeRenderPass() {
    const VkAttachmentDescription attachment = windowAttachment(presenter_.swapchain().format());
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    // What follows may copy the picture before it is shown.
    VkSubpassDependency after{};
    after.srcSubpass = 0;
    after.dstSubpass = VK_SUBPASS_EXTERNAL;
    after.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    after.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    after.dstStageMask = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    after.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &attachment;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 1;
    info.pDependencies = &after;
    VkRenderPass renderPass = VK_NULL_HANDLE;
    device_.check(vkCreateRenderPass(device_.handle(), &info, nullptr, &renderPass),
                  "cannot make the render pass of the controls");
    renderPass_ = {device_.handle(), renderPass};
}

void UserInterface::makeDescriptorPool() {
    const VkDescriptorPoolSize letters{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    info.maxSets = 1;
    info.poolSizeCount = 1;
    info.pPoolSizes = &letters;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    device_.check(vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool),
                  "cannot make the descriptor pool of the controls");
    descriptorPool_ = {device_.handle(), pool};
}

void UserInterface::start(const Window& window) {
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = device_.instance();
    info.PhysicalDevice = device_.physicalDevice();
    info.Device = device_.handle();
    info.QueueFamily = device_.queueFamily();
    info.Queue = device_.queue();
    info.DescriptorPool = descriptorPool_.get();
    info.MinImageCount = 2;
    // Vertices of so many pictures are kept: those that are drawn while others wait to be shown.
    info.ImageCount = static_cast<std::uint32_t>(presenter_.swapchain().images().size());
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = checkResult;
    try {
        ImGui_ImplVulkan_Init(&info, renderPass_.get());
        uploadLetters();
    } catch (...) {
        ImGui_ImplVulkan_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        throw;
    }
}

void UserInterface::uploadLetters() {
    gpu::runCommands(device_,
                     [](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

void UserInterface::draw(const std::function<void()>& panels) {
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    try {
        panels();
    } catch (...) {
        ImGui::ErrorCheckEndFrameRecover(nullptr);  // ends the panels that were begun
        ImGui::Render();
        throw;
    }
    ImGui::Render();
}

void UserInterface::makeFramebuffers() {
    if (generation_ == presenter_.generation()) return;
    const gpu::Swapchain& swapchain = presenter_.swapchain();
    framebuffers_.clear();
    for (const gpu::SwapchainImage& image : swapchain.images()) {
        VkFramebufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
        info.renderPass = renderPass_.get();
        info.attachmentCount = 1;
        info.pAttachments = &image.view;
        info.width = swapchain.extent().width;
        info.height = swapchain.extent().height;
        info.layers = 1;
        VkFramebuffer framebuffer = VK_NULL_HANDLE;
        device_.check(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffer),
                      "cannot draw controls in the window");
        framebuffers_.emplace_back(device_.handle(), framebuffer);
    }
    generation_ = presenter_.generation();
}

void UserInterface::record(VkCommandBuffer commands, const gpu::SwapchainImage& image) {
    makeFramebuffers();
    VkRenderPassBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = renderPass_.get();
    info.framebuffer = framebuffers_[image.index].get();
    info.renderArea.extent = presenter_.swapchain().extent();
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
    vkCmdEndRenderPass(commands);
}

}  // namespace nephrite::view
