// The languages that the program's own words in a picture can have.
#pragma once

namespace carom {

enum class Language { english, german, french, spanish };

}  // namespace carom
