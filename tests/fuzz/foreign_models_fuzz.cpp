// Collada and FBX: assimp may do what it likes in its confined process, as long as that ends and what it
// answers does our reader of glTF no harm.
#include "engine/assets/foreign/model_export_impl.h"
#include "engine/assets/model/model_pose.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/process/sandbox.h"
#include "tests/engine/assets/foreign/collada.h"
#include "tests/fuzz/fuzz_target.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>

namespace plumbline::fuzz {
namespace {

constexpr std::size_t kMiB = 1024ULL * 1024;

constexpr std::string_view kFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}
GlobalSettings:  {
  Version: 1000
  Properties70:  {
    P: "UpAxis", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",1
  }
}
Objects:  {
  Geometry: 1, "Geometry::g", "Mesh" {
    Vertices: *9 {
      a: 0,0,0,100,0,0,0,200,0
    }
    PolygonVertexIndex: *3 {
      a: 0,1,-3
    }
  }
  Model: 2, "Model::m", "Mesh" {
    Version: 232
  }
  Material: 3, "Material::red", "" {
    Version: 102
  }
}
Connections:  {
  C: "OO",2,0
  C: "OO",1,2
  C: "OO",3,2
}
)";

/// In the child: the answer, as far as there is one, into the pipe.
[[noreturn]] void decode(std::string_view bytes, int answer) {
    ::dup2(answer, STDOUT_FILENO);
    if (!enter_sandbox({.memory_bytes = 512 * kMiB, .cpu_s = 8})) _exit(1);
    try {
        const Result<std::string> glb = assets::glb_of_foreign_model(bytes, "mutant");
        if (!glb) _exit(2);
        for (std::string_view rest = *glb; !rest.empty();) {
            const ssize_t count = ::write(STDOUT_FILENO, rest.data(), rest.size());
            if (count <= 0) _exit(1);
            rest.remove_prefix(static_cast<std::size_t>(count));
        }
    } catch (const std::bad_alloc&) {
        _exit(2);
    }
    _exit(0);
}

std::string answer_to(std::string_view bytes) {
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    const pid_t child = ::fork();
    if (child == 0) decode(bytes, ends[1]);
    ::close(ends[1]);
    std::string answer;
    std::array<char, 65536> block{};
    for (ssize_t count = 1; count > 0;) {
        count = ::read(ends[0], block.data(), block.size());
        if (count > 0) answer.append(block.data(), static_cast<std::size_t>(count));
    }
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    return answer;
}

}  // namespace

std::vector<std::string> seeds() {
    return {std::string(assets::test::kCollada), std::string(kFbx)};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace plumbline::assets;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (!foreign_model_fault(bytes).empty()) return 0;
    const std::string glb = plumbline::fuzz::answer_to(bytes);
    if (glb.empty()) return 0;
    ModelReferences references("/nonexistent/m", "/nonexistent");
    references.expect_paths_of_another_machine();
    const plumbline::Result<ModelData> model = read_gltf(glb, "mutant", references);
    if (!model) return model.error().message.empty() ? 1 : 0;
    plumbline::fuzz::note_taken();
    merged_mesh(*model, rest_pose(*model), "mutant");
    return 0;
}
