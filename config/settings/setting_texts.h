#pragma once
#include "config/settings/setting_rows.h"
