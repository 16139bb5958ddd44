// Writes the tree of glsl_tree.h as C99 that is C++ too.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/formats/tree_writer.h"

namespace nacre {

// The text with the prefix and an underscore where it says @.
std::string with_prefix(std::string_view text, const std::string& prefix);

class CWriter final : public TreeWriter {
  public:
    using TreeWriter::TreeWriter;

    // Vectors and the text's own structs.
    std::string structs() const;
    std::string constants();
    // What the functions written so far need of vectors and of <math.h>.
    std::string helpers() const;

    std::string type(std::string_view glsl) const override;
    std::string name_of(const GlslFunction& function) const override;

  private:
    std::string literal(const GlslExpression& e) const override;
    std::string construct(const GlslExpression& e) override;
    std::string built_in(const GlslExpression& e) override;
    std::string zero(std::string_view type) const override;
    std::string vector_operation(std::string_view sign, const GlslExpression& a,
                                 const GlslExpression& b) override;
    std::string vector_negative(const GlslExpression& a) override;
    std::string unused(std::string_view parameter) const override;

    // A helper's name, which is then written too.
    std::string helper(const std::string& name);
    std::string as_vector(const GlslExpression& e, std::string_view type);

    std::set<std::string> used_;
};

}  // namespace nacre
