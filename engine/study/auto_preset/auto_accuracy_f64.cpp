// Of the program plumbline-f64, which studies nothing: studies are the other program's.
#include "engine/study/auto_preset/auto_accuracy.h"

namespace plumbline::study {

Result<scene::Accuracy> studied_accuracy(const scene::OpenedScene& /*scene*/) {
    return Error{.message = "studies are the float32 program's"};
}

}  // namespace plumbline::study
