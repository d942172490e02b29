
'use strict';
(() => {
  const charts = JSON.parse(document.getElementById('charts').textContent);
  const canvases = document.querySelectorAll('canvas');
  const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  const dataset = (curve, k) => ({
    label: curve.name,
    data: curve.x.map((x, i) => ({ x, y: curve.y[i] })),
    showLine: curve.mark !== 'points',
    borderDash: curve.mark === 'dashed' ? [6, 4] : [],
    borderWidth: curve.mark === 'dashed' ? 2 : 1.6,
    pointRadius: curve.mark === 'points' ? 4 : 0,
    pointHitRadius: 6,
    borderColor: colour('--curve-' + k % 5),
    backgroundColor: colour('--curve-' + k % 5),
  });

  const axis = text => ({
    type: 'linear',
    title: { display: true, text, color: colour('--quiet') },
    ticks: { color: colour('--quiet') },
    grid: { color: colour('--rule') },
  });

  const draw = (chart, canvas) => new Chart(canvas, {
    type: 'scatter',
    data: { datasets: chart.curves.map(dataset) },
    options: {
      animation: false,
      maintainAspectRatio: false,
      scales: { x: axis(chart.x), y: axis(chart.y) },
      plugins: { legend: { labels: { color: colour('--ink'), boxWidth: 24, boxHeight: 2 } } },
    },
  });

  let drawn = charts.map((chart, i) => draw(chart, canvases[i]));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    drawn.forEach(chart => chart.destroy());
    drawn = charts.map((chart, i) => draw(chart, canvases[i]));
  });
})();
