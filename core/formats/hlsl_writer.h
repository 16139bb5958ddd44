// Writes the tree of glsl_tree.h as HLSL of shader model 5.
#pragma once

#include "core/formats/tree_writer.h"

namespace nacre {

class HlslWriter final : public TreeWriter {
  public:
    using TreeWriter::TreeWriter;

    std::string structs() const;
    std::string constants();

    std::string type(std::string_view glsl) const override;
    std::string name_of(const GlslFunction& function) const override;

  private:
    std::string own_name(const std::string& name) const override;
    std::string literal(const GlslExpression& e) const override;
    std::string construct(const GlslExpression& e) override;
    std::string built_in(const GlslExpression& e) override;
    std::string zero(std::string_view type) const override;
    std::string unused(std::string_view parameter) const override;
};

}  // namespace nacre
