#include "core/base/system/output_guard.h"

#include <doctest/doctest.h>

#include "core/design/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

std::string refusal(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
    return user_error_of([&] { check_outputs(outputs, inputs); });
}

struct Elsewhere {
    explicit Elsewhere(const fs::path& folder) : before(fs::current_path()) { fs::current_path(folder); }
    ~Elsewhere() { fs::current_path(before); }
    const fs::path before;
};

}  // namespace

TEST_SUITE("output guard") {
    TEST_CASE("output guard: an input is refused by every name that leads to it, and both are named") {
        const TemporaryFolder folder;
        const fs::path input = folder / "d.nacre";
        write_all(input, "design");
        fs::create_directories(folder / "sub/deep");
        fs::create_symlink("d.nacre", folder / "link");
        fs::create_symlink("link", folder / "link-to-link");
        fs::create_symlink(input, folder / "sub/absolute");
        fs::create_hard_link(input, folder / "hard");
        fs::create_directory_symlink("sub/deep", folder / "shortcut");
        for (const char* name : {"d.nacre", "./d.nacre", "sub/../d.nacre", "link", "link-to-link",
                                 "sub/absolute", "hard", "shortcut/../../d.nacre"}) {
            CAPTURE(name);
            const std::string line = refusal({folder / "free.png", folder / name}, {"/dev/null", input});
            CHECK(line.starts_with((folder / name).string() + ": write: "));
            CHECK(line.find("(" + input.string() + ")") != std::string::npos);
        }
        const Elsewhere here(folder.path());
        CHECK(!refusal({"d.nacre"}, {input}).empty());
        CHECK(!refusal({input}, {"link"}).empty());
    }

    TEST_CASE("output guard: other files, also of the same bytes or name, are taken") {
        const TemporaryFolder folder;
        write_all(folder / "d.nacre", "design");
        write_all(folder / "copy.nacre", "design");
        fs::create_directory(folder / "sub");
        write_all(folder / "sub/d.nacre", "design");
        CHECK(
            refusal({folder / "copy.nacre", folder / "sub/d.nacre", folder / "new", folder / "not/there/new"},
                    {folder / "d.nacre"})
                .empty());
        CHECK(refusal({folder / "new"}, {folder / "new"}).empty());
        CHECK(refusal({}, {}).empty());
    }

    TEST_CASE("output guard: two outputs that are one file, there or not") {
        const TemporaryFolder folder;
        write_all(folder / "a.png", "old");
        fs::create_symlink("a.png", folder / "b.png");
        fs::create_symlink("new.png", folder / "dangling.png");
        fs::create_symlink("turning", folder / "turning");
        CHECK(!refusal({folder / "a.png", folder / "b.png"}, {}).empty());
        CHECK(!refusal({folder / "new.png", folder / "./new.png"}, {}).empty());
        CHECK(!refusal({folder / "dangling.png", folder / "new.png"}, {}).empty());
        CHECK(!refusal({folder / "not/there/new", folder / "not/../not/there/new"}, {}).empty());
        CHECK(refusal({folder / "a.png", folder / "new.png"}, {}).empty());
        CHECK(refusal({folder / "turning"}, {}).find("(Too many levels of symbolic links)") !=
              std::string::npos);
    }

    TEST_CASE("output guard: letter case counts where the file system says so") {
        const TemporaryFolder folder;
        const bool ignored = ignores_case(folder.path());
        write_all(folder / "probe", "");
        CHECK(fs::exists(folder / "PROBE") == ignored);
        CHECK(refusal({folder / "a.png", folder / "A.png"}, {}).empty() == !ignored);
        CHECK(refusal({folder / "PROBE"}, {folder / "probe"}).empty() == !ignored);
        CHECK(without_case("Ähre-ÉTÉ-Ω.png") == "ähre-été-ω.png");
        CHECK(without_case("a\xff"
                           "B\xc3") ==
              "a\xff"
              "b\xc3");
        CHECK(without_case("") == "");
    }

    TEST_CASE("output guard: a design names the pictures of all its layers, each once") {
        Design design;
        design.distribution.layers = {Layer{}, Layer{}, Layer{}};
        design.distribution.layers[0].lobe = PaintedLobe{{"/p/a.png", {}}};
        design.distribution.layers[1].enabled = false;
        design.distribution.layers[1].lobe = PaintedLobe{};
        design.distribution.layers[1].modulation = Modulation{{"/p/b.exr", {}}, 1};
        design.distribution.layers[2].modulation = Modulation{{"/p/a.png", {}}, 1};
        CHECK(picture_files(design) == std::vector<fs::path>{"/p/a.png", "/p/b.exr"});
        CHECK(picture_files(Design{}).empty());
    }
}
