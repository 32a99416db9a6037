// How the controls look: letters, colours, spaces.
#pragma once

#include <imgui.h>

namespace nephrite::view {

/// Sets the style of the current context; `scale` is how much larger than usual letters are wanted. To be
/// called before the letters are uploaded.
void applyStyle(float scale);

/// Colours that say something.
namespace color {
inline const ImVec4 fault{1.0F, 0.45F, 0.40F, 1};
inline const ImVec4 good{0.45F, 0.85F, 0.55F, 1};
inline const ImVec4 changed{1.0F, 0.80F, 0.35F, 1};
inline const ImVec4 quiet{0.60F, 0.63F, 0.66F, 1};
inline const ImVec4 accent{0.25F, 0.62F, 0.50F, 1};
inline const ImVec4 gpu{0.30F, 0.70F, 0.55F, 1};
inline const ImVec4 cpu{0.45F, 0.58F, 0.85F, 1};
inline const ImVec4 skipped{0.80F, 0.58F, 0.30F, 1};
inline const ImVec4 fed{0.45F, 0.75F, 1.0F, 1};
}  // namespace color

}  // namespace nephrite::view
