#include "scene/language.h"

#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/reading/set_reading.h"

namespace carom {

Section scene_section(PanelKinds kinds, int dimension) {
    return scene_table(kinds, dimension).section();
}

Section template_section(PanelKinds kinds) { return template_table(kinds).section(); }

Section set_section(PanelKinds kinds) { return set_table(kinds, {}).section(); }

}  // namespace carom
