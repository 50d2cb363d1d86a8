#include "engine/assets/checked_model.h"

namespace plumbline::assets {

Result<CheckedModel> check_obj(std::string_view bytes,
                               const std::string& name,
                               ModelReferences& references) {
    CheckedModel model{.main_name = "model.obj"};
    model.files.emplace(model.main_name, std::string(bytes));
    static_cast<void>(references);
    static_cast<void>(name);
    return model;
}

}  // namespace plumbline::assets
