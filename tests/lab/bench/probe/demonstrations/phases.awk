# What was felt between the hand's places: the places' file first, then RUN.csv. Set demo.

FNR == NR {
    if (FNR > 1) { n = FNR - 1; t[n] = $1; phase[n] = $5 }
    next
}

FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }

function field(name) { return $column[name] }
function size(v) { return v < 0 ? -v : v }
function told(v, digits) { v = sprintf("%." digits "f", v); return v + 0 == 0 ? sprintf("%." digits "f", 0) : v }

{
    k = 1
    while (k < n - 1 && field("t_s") > t[k + 1]) k++
    force = sqrt(field("fx_N") ^ 2 + field("fy_N") ^ 2)
    count[k]++
    sum[k] += force
    if (force > most[k]) most[k] = force
    if (size(field("torque_Nm")) > torque[k]) torque[k] = size(field("torque_Nm"))
    x[k] = field("proxy_x_m"); y[k] = field("proxy_y_m"); angle[k] = field("proxy_angle_rad") * 180 / atan2(0, -1)
    ticks++
}

END {
    for (k = 1; k < n; k++)
        printf "%s,%s,%.2f,%.2f,%.1f,%s,%s,%s\n", demo, phase[k], sum[k] / count[k], most[k], torque[k] * 1000, \
            told(x[k] * 1000, 1), told(y[k] * 1000, 1), told(angle[k], 0)
}
