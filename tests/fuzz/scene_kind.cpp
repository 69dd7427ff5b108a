// Random scenes, run as they are and judged by their motion.

#include "corpus.h"
#include "kind.h"
#include "scene.h"
#include "scene_judge.h"

namespace flyrock::fuzz {

namespace {

class Scenes : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    const Scene scene = make_scene(dice);
    if (!is_promised(scene)) call.only_list();
    write_here("s.yaml", scene.text);
    const int code = call({"run", "s.yaml", "-o", "out", "--force", "--quiet", "-j", "1"}, ErrorForm::placed);
    call.blame(code == cli::bad_input ? "a scene that should be sound is bad input"
                                      : fault_of_scene(scene, "out"));
  }
};

}  // namespace

std::unique_ptr<Kind> make_scene_kind() { return std::make_unique<Scenes>(); }

}  // namespace flyrock::fuzz
