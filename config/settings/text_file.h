#pragma once
#include "config/settings/settings_text.h"
